#include "tests/bench/explicit_graph.h"

#include <algorithm>

#include "core/cut/fixed_point.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

void NumberVertices(const VoxelGrid& crust,
                    std::span<const FaceTies> merged_ties,
                    ExplicitGraph& graph) {
  const VoxelWalk walk(crust, Context(1));
  graph.vertices.resize(crust.Size());
  // A face is numbered by the voxel on its upper side.
  walk.ForEachWithNeighbors(
      0, walk.NumBricks(), [&](const VoxelSlot& slot, const auto& neighbors) {
        const FaceTies ties = merged_ties[slot.index];
        for (int face = 0; face < kNumFaces; ++face) {
          if (ties & OutsideTie(face)) {
            graph.vertices[slot.index][face] = ExplicitGraph::kSource;
          } else if (ties & InsideTie(face)) {
            graph.vertices[slot.index][face] = ExplicitGraph::kSink;
          } else if ((face & 1) == 0) {
            graph.vertices[slot.index][face] = graph.num_vertices;
            graph.vertices[neighbors[face]][face + 1] = graph.num_vertices++;
          }
        }
      });
}

// Terminal arcs are summed by vertex: {from the source, to the sink}.
using TerminalArcs = std::vector<std::array<int64_t, 2>>;

void AddVoxel(size_t voxel, ExplicitGraph& graph, TerminalArcs& terminal) {
  const auto& vertices = graph.vertices[voxel];
  const int64_t weight = graph.weights[voxel];
  for (int f = 0; f < kNumFaces; ++f) {
    for (int g = f + 1; g < kNumFaces; ++g) {
      const auto [a, b] = std::minmax(vertices[f], vertices[g]);
      if (f / 2 == g / 2 || a == b) {
        continue;
      }
      if (b == ExplicitGraph::kSink) {
        graph.direct_flow += weight;
      } else if (a < ExplicitGraph::kFirstNode) {
        terminal[b][a] += weight;
      } else {
        ++graph.num_edges;
      }
    }
  }
}

void AddEvidence(const OctahedralCutProblem& problem,
                 const ExplicitGraph& graph,
                 TerminalArcs& terminal) {
  std::vector<int64_t> inside(graph.num_vertices, 0);
  for (size_t i = 0; i < problem.evidence.size(); ++i) {
    for (const uint32_t vertex : graph.vertices[i]) {
      inside[vertex] += FixedFaceEvidence(problem.evidence[i]);
    }
  }
  for (uint32_t v = ExplicitGraph::kFirstNode; v < graph.num_vertices; ++v) {
    terminal[v][inside[v] > 0 ? ExplicitGraph::kSink
                              : ExplicitGraph::kSource] += std::abs(inside[v]);
  }
}

}  // namespace

ExplicitGraph BuildExplicitGraph(const OctahedralCutProblem& problem,
                                 std::span<const FaceTies> merged_ties) {
  ExplicitGraph graph;
  NumberVertices(*problem.crust, merged_ties, graph);
  TerminalArcs terminal(graph.num_vertices, {0, 0});
  graph.weights.resize(problem.crust->Size());
  for (size_t i = 0; i < problem.crust->Size(); ++i) {
    graph.weights[i] = FixedWeight(problem.weights[i]);
    AddVoxel(i, graph, terminal);
  }
  AddEvidence(problem, graph, terminal);
  graph.terminal.resize(graph.num_vertices, 0);
  for (uint32_t v = ExplicitGraph::kFirstNode; v < graph.num_vertices; ++v) {
    const auto [source, sink] = terminal[v];
    graph.direct_flow += std::min(source, sink);
    graph.terminal[v] = source - sink;
  }
  return graph;
}

}  // namespace octacut
