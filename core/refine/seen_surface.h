// What a round of refinement knows of the surface before it measures: points on
// it, its shape there and the views that see it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/vertex_corners.h"
#include "core/raycast/ray_scene.h"
#include "core/refine/local_surface.h"
#include "core/refine/refine_options.h"
#include "core/refine/surface_points.h"
#include "core/refine/view_choice.h"
#include "core/views/view_set.h"

namespace octacut {

// The size of a pixel of `views` at the mean position of `mesh` (unit
// coordinates), which has vertices; 0 where that lies behind all cameras.
double PixelSizeAt(const ViewSet& views, const IndexedMesh& mesh);

// What a round looks at, and how; lengths in unit coordinates.
struct Look {
  const ViewSet& views;
  const VertexCorners& neighbors;  // those of FindVertexNeighbors
  const RefineOptions& options;
  double pixel;        // of the views, at the surface
  double scale = 1;    // pixels between the samples of a patch
  double spacing = 0;  // between the points of LookAtSurface
  // Vertices that count, one element each; no other points have views. Empty:
  // all do.
  std::span<const uint8_t> part = {};
};

struct SeenSurface {
  double edge;  // mean one of the mesh
  SurfacePoints points;
  std::vector<LocalSurface> surfaces;  // at the points
  RayScene rays;                       // of the mesh
  std::vector<ChosenViews> choices;    // of the points
  std::vector<uint8_t> is_seen;        // by at least two views

  size_t NumSeen() const;
};

// `mesh` (unit coordinates) is given normals.
SeenSurface LookAtSurface(const Look& look,
                          const Context& context,
                          IndexedMesh* mesh);

// The same at points of another look at the mesh, whose vertices may have moved
// since.
SeenSurface LookAtPoints(SurfacePoints points,
                         const Look& look,
                         const Context& context,
                         IndexedMesh* mesh);

}  // namespace octacut
