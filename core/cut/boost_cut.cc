#include "core/cut/boost_cut.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <numeric>

#include "core/cut/brick_neighbors.h"
#include "core/cut/fixed_point.h"

namespace octacut {
namespace {

using Graph = boost::compressed_sparse_row_graph<boost::directedS>;
using Vertex = boost::graph_traits<Graph>::vertex_descriptor;
using Edge = boost::graph_traits<Graph>::edge_descriptor;

constexpr uint32_t kSource = 0;
constexpr uint32_t kSink = 1;
constexpr uint32_t kFirstNode = 2;

// A pair of arcs a -> b and b -> a.
struct ArcPair {
  uint32_t a, b;
  int64_t capacity, reverse_capacity;
};

struct FaceNodes {
  // Vertex of each face of each voxel; tied ones are the terminals.
  std::vector<std::array<uint32_t, kNumFaces>> of_voxel;
  uint32_t num_vertices = kFirstNode;
};

FaceNodes NumberNodes(const VoxelGrid& grid,
                      std::span<const FaceTies> merged_ties) {
  FaceNodes nodes;
  nodes.of_voxel.resize(grid.Size());
  // A face is numbered by the voxel on its upper side.
  ForEachWithNeighbors(
      grid,
      0,
      grid.Bricks().size(),
      [&](VoxelGrid::Index i, MortonCode, const auto& neighbors) {
        for (int face = 0; face < kNumFaces; ++face) {
          if (merged_ties[i] & OutsideTie(face)) {
            nodes.of_voxel[i][face] = kSource;
          } else if (merged_ties[i] & InsideTie(face)) {
            nodes.of_voxel[i][face] = kSink;
          } else if ((face & 1) == 0) {
            nodes.of_voxel[i][face] = nodes.num_vertices;
            nodes.of_voxel[neighbors[face]][face + 1] = nodes.num_vertices++;
          }
        }
      });
  return nodes;
}

// Arcs inside a voxel; terminal arcs are summed in `terminal` (> 0: from the
// source), and what flows directly from source to sink is returned.
int64_t VoxelArcs(const std::array<uint32_t, kNumFaces>& nodes,
                  int64_t weight,
                  std::vector<ArcPair>& arcs,
                  std::vector<std::array<int64_t, 2>>& terminal) {
  int64_t direct = 0;
  for (int f = 0; f < kNumFaces; ++f) {
    for (int g = f + 1; g < kNumFaces; ++g) {
      const auto [a, b] = std::minmax(nodes[f], nodes[g]);
      if (f / 2 == g / 2 || a == b) {
        continue;
      }
      if (b == kSink) {
        direct += weight;
      } else if (a < kFirstNode) {
        terminal[b][a] += weight;
      } else {
        arcs.push_back({a, b, weight, weight});
      }
    }
  }
  return direct;
}

void AddEvidence(const OctahedralCutProblem& problem,
                 const FaceNodes& nodes,
                 std::vector<std::array<int64_t, 2>>& terminal) {
  std::vector<int64_t> inside(nodes.num_vertices, 0);
  for (size_t i = 0; i < problem.evidence.size(); ++i) {
    for (const uint32_t node : nodes.of_voxel[i]) {
      inside[node] += FixedFaceEvidence(problem.evidence[i]);
    }
  }
  for (uint32_t node = kFirstNode; node < nodes.num_vertices; ++node) {
    terminal[node][inside[node] > 0 ? kSink : kSource] +=
        std::abs(inside[node]);
  }
}

struct FlowNetwork {
  Graph graph;
  std::vector<int64_t> capacity, residual;
  std::vector<Edge> reverse;
};

FlowNetwork BuildNetwork(const std::vector<ArcPair>& arcs,
                         uint32_t num_vertices) {
  std::vector<size_t> next(num_vertices + 1, 0);
  for (const ArcPair& arc : arcs) {
    ++next[arc.a + 1];
    ++next[arc.b + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  FlowNetwork network;
  std::vector<std::pair<uint32_t, uint32_t>> ends(2 * arcs.size());
  network.capacity.resize(ends.size());
  std::vector<size_t> reverse(ends.size());
  for (const ArcPair& arc : arcs) {
    const size_t ab = next[arc.a]++;
    const size_t ba = next[arc.b]++;
    ends[ab] = {arc.a, arc.b};
    ends[ba] = {arc.b, arc.a};
    network.capacity[ab] = arc.capacity;
    network.capacity[ba] = arc.reverse_capacity;
    reverse[ab] = ba;
    reverse[ba] = ab;
  }
  network.graph =
      Graph(boost::edges_are_sorted, ends.begin(), ends.end(), num_vertices);
  network.residual.resize(ends.size());
  network.reverse.resize(ends.size());
  for (size_t e = 0; e < ends.size(); ++e) {
    network.reverse[e] = Edge(ends[reverse[e]].first, reverse[e]);
  }
  return network;
}

int64_t MaximumFlow(FlowNetwork& network) {
  const size_t n = num_vertices(network.graph);
  const auto edge_index = get(boost::edge_index, network.graph);
  const auto vertex_index = get(boost::vertex_index, network.graph);
  std::vector<Edge> predecessor(n);
  std::vector<boost::default_color_type> color(n);
  std::vector<long> distance(n);
  const auto by_edge = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), edge_index);
  };
  const auto by_vertex = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), vertex_index);
  };
  return boost::boykov_kolmogorov_max_flow(network.graph,
                                           by_edge(network.capacity),
                                           by_edge(network.residual),
                                           by_edge(network.reverse),
                                           by_vertex(predecessor),
                                           by_vertex(color),
                                           by_vertex(distance),
                                           vertex_index,
                                           Vertex(kSource),
                                           Vertex(kSink));
}

// Vertices that residual arcs reach from the source: the least source side.
std::vector<bool> ReachedFromSource(const FlowNetwork& network) {
  std::vector<bool> reached(num_vertices(network.graph), false);
  const auto edge_index = get(boost::edge_index, network.graph);
  std::vector<Vertex> stack = {kSource};
  reached[kSource] = true;
  while (!stack.empty()) {
    const Vertex vertex = stack.back();
    stack.pop_back();
    for (auto [e, end] = out_edges(vertex, network.graph); e != end; ++e) {
      const Vertex to = target(*e, network.graph);
      if (network.residual[get(edge_index, *e)] > 0 && !reached[to]) {
        reached[to] = true;
        stack.push_back(to);
      }
    }
  }
  return reached;
}

}  // namespace

OctahedralCut SolveWithBoost(const OctahedralCutProblem& problem,
                             std::span<const FaceTies> merged_ties) {
  const FaceNodes nodes = NumberNodes(*problem.crust, merged_ties);
  std::vector<ArcPair> arcs;
  std::vector<std::array<int64_t, 2>> terminal(nodes.num_vertices, {0, 0});
  OctahedralCut cut;
  for (size_t i = 0; i < nodes.of_voxel.size(); ++i) {
    cut.cost_fixed_point += VoxelArcs(
        nodes.of_voxel[i], FixedWeight(problem.weights[i]), arcs, terminal);
  }
  AddEvidence(problem, nodes, terminal);
  for (uint32_t node = kFirstNode; node < nodes.num_vertices; ++node) {
    // What can pass straight through needs no search.
    const int64_t through =
        std::min(terminal[node][kSource], terminal[node][kSink]);
    cut.cost_fixed_point += through;
    if (terminal[node][kSource] > through) {
      arcs.push_back({kSource, node, terminal[node][kSource] - through, 0});
    } else if (terminal[node][kSink] > through) {
      arcs.push_back({node, kSink, terminal[node][kSink] - through, 0});
    }
  }
  FlowNetwork network = BuildNetwork(arcs, nodes.num_vertices);
  cut.cost_fixed_point += MaximumFlow(network);
  const std::vector<bool> outside = ReachedFromSource(network);
  cut.num_nodes = nodes.num_vertices - kFirstNode;
  cut.labels.resize(nodes.of_voxel.size());
  for (size_t i = 0; i < nodes.of_voxel.size(); ++i) {
    for (int face = 0; face < kNumFaces; ++face) {
      cut.labels[i] |= FaceLabels(!outside[nodes.of_voxel[i][face]] << face);
    }
  }
  return cut;
}

size_t EstimateBoostCutBytes(size_t num_voxels, bool with_evidence) {
  // At most three nodes of 72 bytes and twelve arc pairs of 32 + 2 * 48 bytes
  // a voxel, with the doubling of a growing vector.
  return num_voxels * (with_evidence ? 2300 : 2200) + (1 << 20);
}

}  // namespace octacut
