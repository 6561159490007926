// The octahedral graph of a problem, explicitly: what a linked solver needs.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/cut/octahedral_cut.h"

namespace octacut {

struct ExplicitGraph {
  static constexpr uint32_t kSource = 0;
  static constexpr uint32_t kSink = 1;
  static constexpr uint32_t kFirstNode = 2;

  // Undirected: the same capacity both ways.
  struct Edge {
    uint32_t a, b;
    int64_t capacity;
  };

  // Vertex of each face of each voxel; that of a tied one is a terminal.
  std::vector<std::array<uint32_t, kNumFaces>> vertices;
  uint32_t num_vertices = kFirstNode;
  std::vector<Edge> edges;
  // By vertex: from the source (> 0) or to the sink (< 0), net.
  std::vector<int64_t> terminal;
  // Flow that needs no search: from source to sink, and through one node.
  int64_t direct_flow = 0;
};

ExplicitGraph BuildExplicitGraph(const OctahedralCutProblem& problem,
                                 std::span<const FaceTies> merged_ties);

// Labels from the side of every vertex.
template <typename IsSource>
std::vector<FaceLabels> LabelsFromSides(const ExplicitGraph& graph,
                                        IsSource&& is_source) {
  std::vector<FaceLabels> labels(graph.vertices.size(), 0);
  for (size_t i = 0; i < labels.size(); ++i) {
    for (int face = 0; face < kNumFaces; ++face) {
      const uint32_t vertex = graph.vertices[i][face];
      const bool inside =
          vertex == ExplicitGraph::kSink ||
          (vertex != ExplicitGraph::kSource && !is_source(vertex));
      labels[i] |= FaceLabels(inside << face);
    }
  }
  return labels;
}

}  // namespace octacut
