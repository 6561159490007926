#include "tests/bench/opencv_cut.h"

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

#include "tests/bench/explicit_graph.h"

namespace octacut {

OctahedralCut SolveWithOpenCv(const OctahedralCutProblem& problem,
                              std::span<const FaceTies> merged_ties) {
  const ExplicitGraph graph = BuildExplicitGraph(problem, merged_ties);
  const uint32_t first = ExplicitGraph::kFirstNode;
  // Every capacity and sum is an integer below 2^53, so doubles are exact.
  cv::detail::GCGraph<double> solver(graph.num_vertices - first,
                                     unsigned(2 * graph.num_edges));
  for (uint32_t v = first; v < graph.num_vertices; ++v) {
    const double terminal = double(graph.terminal[v]);
    solver.addTermWeights(
        solver.addVtx(), std::max(terminal, 0.0), std::max(-terminal, 0.0));
  }
  graph.ForEachEdge([&](uint32_t a, uint32_t b, int32_t capacity) {
    solver.addEdges(
        int(a - first), int(b - first), double(capacity), double(capacity));
  });
  OctahedralCut cut;
  cut.cost_fixed_point = graph.direct_flow + std::llround(solver.maxFlow());
  cut.labels = LabelsFromSides(graph, [&](uint32_t vertex) {
    return solver.inSourceSegment(int(vertex - first));
  });
  cut.num_nodes = graph.num_vertices - first;
  return cut;
}

}  // namespace octacut
