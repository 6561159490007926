// How much each photograph counts at each vertex: cross-fades along the
// borders of charts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/vertex_corners.h"
#include "core/texture/face_views.h"
#include "core/texture/view_costs.h"

namespace octacut {

struct VertexView {
  uint32_t vertex;
  uint32_t view;
  float weight;
};

// Photographs of each vertex; between vertices weights are linear.
struct VertexViews {
  std::vector<uint32_t> first = {0};
  std::vector<VertexView> entries;  // by vertex, then by view

  std::span<const VertexView> Of(uint32_t vertex) const {
    return {entries.data() + first[vertex], first[vertex + 1] - first[vertex]};
  }
  // The place of an entry in `entries`, or -1.
  int64_t Find(uint32_t vertex, uint32_t view) const;
};

// What is known of each triangle when weights are computed.
struct FaceChoice {
  const FaceViews& views;
  const ViewCosts& costs;
  const std::vector<uint32_t>& chosen;  // kNoView where no view shows it
};

// Pixels on each side of a border between charts in which one photograph fades
// into the other: enough to hide what is left after the colours were adjusted,
// little enough to keep the detail of both.
inline constexpr float kFadePixels = 8;

// Weights are continuous over the surface: at a vertex, a photograph counts
// only if all triangles around it may be textured from it. Each vertex of a
// triangle has an entry of the view chosen for it, with weight 0 where others
// take its place.
VertexViews FadeViews(const IndexedMesh& mesh,
                      const VertexCorners& vertex_faces,
                      const FaceChoice& chosen,
                      const Context& context);

// Views of less than this share of the best one's resolution add more blur to
// medians and means than they take noise away.
inline constexpr float kMinShare = 0.3f;
// The weight of a view of the best resolution among AllViews.
inline constexpr float kFullSupport = (1 - kMinShare) * (1 - kMinShare);

// For medians and means of views: all photographs that all triangles around a
// vertex may be textured from, weighted by the squares of what their shares of
// the best resolution exceed kMinShare by.
VertexViews AllViews(const IndexedMesh& mesh,
                     const VertexCorners& vertex_faces,
                     const FaceChoice& chosen,
                     const Context& context);

}  // namespace octacut
