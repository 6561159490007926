#include "tests/bench/boost_cut.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <iterator>
#include <numeric>
#include <utility>

#include "tests/bench/explicit_graph.h"

namespace octacut {
namespace {

// As compact as Boost allows: 32-bit numbers of vertices and arcs, and the
// residuals double as capacities. 20 bytes an arc.
using Graph = boost::compressed_sparse_row_graph<boost::directedS,
                                                 boost::no_property,
                                                 boost::no_property,
                                                 boost::no_property,
                                                 uint32_t,
                                                 uint32_t>;
using Vertex = boost::graph_traits<Graph>::vertex_descriptor;
using Arc = boost::graph_traits<Graph>::edge_descriptor;

struct FlowNetwork {
  Graph graph;
  std::vector<int64_t> residual;
  std::vector<Arc> reverse;
};

// Calls body(a, b, capacity, reverse capacity) for every pair of arcs.
template <typename Body>
void ForEachArcPair(const ExplicitGraph& graph, Body&& body) {
  graph.ForEachEdge([&](uint32_t a, uint32_t b, int32_t capacity) {
    body(a, b, int64_t{capacity}, int64_t{capacity});
  });
  for (uint32_t v = ExplicitGraph::kFirstNode; v < graph.num_vertices; ++v) {
    if (graph.terminal[v] > 0) {
      body(ExplicitGraph::kSource, v, graph.terminal[v], int64_t{0});
    } else if (graph.terminal[v] < 0) {
      body(v, ExplicitGraph::kSink, -graph.terminal[v], int64_t{0});
    }
  }
}

// Calls body(ab, ba, a, b, capacity, reverse capacity) with the numbers of the
// arcs; `first` holds the number of each vertex's first arc.
template <typename Body>
void ForEachNumberedArcPair(const ExplicitGraph& graph,
                            std::vector<uint32_t> first,
                            Body&& body) {
  ForEachArcPair(
      graph, [&](uint32_t a, uint32_t b, int64_t forward, int64_t backward) {
        const uint32_t ab = first[a]++;
        body(ab, first[b]++, a, b, forward, backward);
      });
}

// The ends of arcs in order, made as they are asked for.
class ArcEnds {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = std::pair<uint32_t, uint32_t>;
  using difference_type = ptrdiff_t;
  using pointer = const value_type*;
  using reference = const value_type&;

  ArcEnds(const std::vector<uint32_t>& first,
          const std::vector<uint32_t>& heads,
          uint32_t arc)
      : first_(&first), heads_(&heads), arc_(arc) {
    Load();
  }
  reference operator*() const { return ends_; }
  pointer operator->() const { return &ends_; }
  ArcEnds& operator++() {
    ++arc_;
    Load();
    return *this;
  }
  bool operator==(const ArcEnds& other) const { return arc_ == other.arc_; }
  bool operator!=(const ArcEnds& other) const { return arc_ != other.arc_; }

 private:
  void Load() {
    if (arc_ < heads_->size()) {
      while ((*first_)[ends_.first + 1] <= arc_) {
        ++ends_.first;
      }
      ends_.second = (*heads_)[arc_];
    }
  }

  const std::vector<uint32_t>* first_;
  const std::vector<uint32_t>* heads_;
  uint32_t arc_;
  value_type ends_ = {0, 0};
};

FlowNetwork BuildNetwork(const ExplicitGraph& graph) {
  std::vector<uint32_t> first(graph.num_vertices + 1, 0);
  ForEachArcPair(graph, [&](uint32_t a, uint32_t b, int64_t, int64_t) {
    ++first[a + 1];
    ++first[b + 1];
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  const uint32_t num_arcs = first.back();
  FlowNetwork network;
  {
    std::vector<uint32_t> heads(num_arcs);
    ForEachNumberedArcPair(
        graph,
        first,
        [&](uint32_t ab, uint32_t ba, uint32_t a, uint32_t b, auto...) {
          heads[ab] = b;
          heads[ba] = a;
        });
    network.graph = Graph(boost::edges_are_sorted,
                          ArcEnds(first, heads, 0),
                          ArcEnds(first, heads, num_arcs),
                          graph.num_vertices,
                          num_arcs);
  }
  network.residual.resize(num_arcs);
  network.reverse.resize(num_arcs);
  ForEachNumberedArcPair(graph,
                         first,
                         [&](uint32_t ab,
                             uint32_t ba,
                             uint32_t a,
                             uint32_t b,
                             int64_t forward,
                             int64_t backward) {
                           network.residual[ab] = forward;
                           network.residual[ba] = backward;
                           network.reverse[ab] = Arc(b, ba);
                           network.reverse[ba] = Arc(a, ab);
                         });
  return network;
}

int64_t MaximumFlow(FlowNetwork& network) {
  const size_t n = num_vertices(network.graph);
  const auto arc_index = get(boost::edge_index, network.graph);
  const auto vertex_index = get(boost::vertex_index, network.graph);
  std::vector<Arc> predecessor(n);
  std::vector<boost::default_color_type> color(n);
  std::vector<int32_t> distance(n);
  const auto by_arc = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), arc_index);
  };
  const auto by_vertex = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), vertex_index);
  };
  return boost::boykov_kolmogorov_max_flow(network.graph,
                                           by_arc(network.residual),
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
