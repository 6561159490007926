#include "tests/bench/boost_cut.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <numeric>

#include "tests/bench/explicit_graph.h"

namespace octacut {
namespace {

using Graph = boost::compressed_sparse_row_graph<boost::directedS>;
using Vertex = boost::graph_traits<Graph>::vertex_descriptor;
using Arc = boost::graph_traits<Graph>::edge_descriptor;

struct FlowNetwork {
  Graph graph;
  std::vector<int64_t> capacity, residual;
  std::vector<Arc> reverse;
};

// Calls body(a, b, capacity, reverse capacity) for every pair of arcs.
template <typename Body>
void ForEachArcPair(const ExplicitGraph& graph, Body&& body) {
  for (const ExplicitGraph::Edge& edge : graph.edges) {
    body(edge.a, edge.b, edge.capacity, edge.capacity);
  }
  for (uint32_t v = ExplicitGraph::kFirstNode; v < graph.num_vertices; ++v) {
    if (graph.terminal[v] > 0) {
      body(ExplicitGraph::kSource, v, graph.terminal[v], int64_t{0});
    } else if (graph.terminal[v] < 0) {
      body(v, ExplicitGraph::kSink, -graph.terminal[v], int64_t{0});
    }
  }
}

FlowNetwork BuildNetwork(const ExplicitGraph& graph) {
  std::vector<size_t> next(graph.num_vertices + 1, 0);
  ForEachArcPair(graph, [&](uint32_t a, uint32_t b, int64_t, int64_t) {
    ++next[a + 1];
    ++next[b + 1];
  });
  std::partial_sum(next.begin(), next.end(), next.begin());
  FlowNetwork network;
  const size_t num_arcs = next.back();
  std::vector<std::pair<uint32_t, uint32_t>> ends(num_arcs);
  std::vector<size_t> reverse(num_arcs);
  network.capacity.resize(num_arcs);
  ForEachArcPair(
      graph, [&](uint32_t a, uint32_t b, int64_t forward, int64_t backward) {
        const size_t ab = next[a]++;
        const size_t ba = next[b]++;
        ends[ab] = {a, b};
        ends[ba] = {b, a};
        network.capacity[ab] = forward;
        network.capacity[ba] = backward;
        reverse[ab] = ba;
        reverse[ba] = ab;
      });
  network.graph = Graph(
      boost::edges_are_sorted, ends.begin(), ends.end(), graph.num_vertices);
  network.residual.resize(num_arcs);
  network.reverse.resize(num_arcs);
  for (size_t arc = 0; arc < num_arcs; ++arc) {
    network.reverse[arc] = Arc(ends[reverse[arc]].first, reverse[arc]);
  }
  return network;
}

int64_t MaximumFlow(FlowNetwork& network) {
  const size_t n = num_vertices(network.graph);
  const auto arc_index = get(boost::edge_index, network.graph);
  const auto vertex_index = get(boost::vertex_index, network.graph);
  std::vector<Arc> predecessor(n);
  std::vector<boost::default_color_type> color(n);
  std::vector<long> distance(n);
  const auto by_arc = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), arc_index);
  };
  const auto by_vertex = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), vertex_index);
  };
  return boost::boykov_kolmogorov_max_flow(network.graph,
                                           by_arc(network.capacity),
                                           by_arc(network.residual),
                                           by_arc(network.reverse),
                                           by_vertex(predecessor),
                                           by_vertex(color),
                                           by_vertex(distance),
                                           vertex_index,
                                           Vertex(ExplicitGraph::kSource),
                                           Vertex(ExplicitGraph::kSink));
}

// Vertices that residual arcs reach from the source: the least source side.
std::vector<bool> ReachedFromSource(const FlowNetwork& network) {
  std::vector<bool> reached(num_vertices(network.graph), false);
  const auto arc_index = get(boost::edge_index, network.graph);
  std::vector<Vertex> stack = {ExplicitGraph::kSource};
  reached[ExplicitGraph::kSource] = true;
  while (!stack.empty()) {
    const Vertex vertex = stack.back();
    stack.pop_back();
    for (auto [arc, end] = out_edges(vertex, network.graph); arc != end;
         ++arc) {
      const Vertex to = target(*arc, network.graph);
      if (network.residual[get(arc_index, *arc)] > 0 && !reached[to]) {
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
  const ExplicitGraph graph = BuildExplicitGraph(problem, merged_ties);
  FlowNetwork network = BuildNetwork(graph);
  OctahedralCut cut;
  cut.cost_fixed_point = graph.direct_flow + MaximumFlow(network);
  const std::vector<bool> reached = ReachedFromSource(network);
  cut.labels =
      LabelsFromSides(graph, [&](uint32_t vertex) { return reached[vertex]; });
  cut.num_nodes = graph.num_vertices - ExplicitGraph::kFirstNode;
  return cut;
}

}  // namespace octacut
