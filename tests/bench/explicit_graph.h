// The octahedral graph of a problem, explicitly: what a linked solver needs.
#pragma once

#include <algorithm>
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

  // Vertex of each face of each voxel; that of a tied one is a terminal.
  std::vector<std::array<uint32_t, kNumFaces>> vertices;
  std::vector<int32_t> weights;  // of each voxel
  uint32_t num_vertices = kFirstNode;
  // Edges between two vertices that are not terminals.
  size_t num_edges = 0;
  // By vertex: from the source (> 0) or to the sink (< 0), net.
  std::vector<int64_t> terminal;
  // Flow that needs no search: from source to sink, and through one node.
  int64_t direct_flow = 0;

  // Calls body(a, b, capacity) for every such edge, which has the same
  // capacity both ways. Not stored: a linked solver stores its own.
  template <typename Body>
  void ForEachEdge(Body&& body) const {
    for (size_t i = 0; i < vertices.size(); ++i) {
      for (int f = 0; f < kNumFaces; ++f) {
        for (int g = (f | 1) + 1; g < kNumFaces; ++g) {
          if (std::min(vertices[i][f], vertices[i][g]) >= kFirstNode) {
            body(vertices[i][f], vertices[i][g], weights[i]);
          }
        }
      }
    }
  }
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
