// What photographs and silhouettes say of a finished surface, point by point.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/raycast/ray_scene.h"
#include "core/refine/refine_options.h"
#include "core/refine/surface_points.h"
#include "core/views/view_set.h"

namespace octacut {

// Lengths in pixels of the views at the point.
struct PointEvidence {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  // unit coordinates
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();    // outward
  float area = 0;     // of the surface that it stands for, unit^2
  int num_views = 0;  // that see it, and differ in direction
  // The agreement of the views about the surface where it is, -1 .. 1, as
  // SurfacePatch has it; none where fewer than two show the patch.
  std::optional<float> agreement;
  // Where along the normal the views agree best, and how precisely that is
  // known: 1 / standard deviation, 0 where there is no such offset.
  float offset = 0;
  float precision = 0;
  // From the visual hull of the masks, as shifted: the least distance from the
  // border of an object's silhouette, negative outside.
  float hull_distance = 0;
  int num_contours = 0;  // views that have it beside that border
  // Mean curvature times the pixel size: positive where convex.
  float curvature = 0;
};

struct SurfaceEvidence {
  RayScene rays;                      // of the mesh
  SurfacePoints points;               // which vertices each point stands for
  std::vector<PointEvidence> values;  // one per point
  double pixel = 0;                   // of the views, at the mesh
};

struct SurfaceEvidenceOptions {
  // How views are chosen, surfaces fitted and patches compared.
  RefineOptions refinement = {};
  double spacing = 4;  // of the points, pixels
  // Pixels by which the masks have been found to be too large.
  double border_shift = 0;
};

// `mesh`, closed, in unit coordinates; it is given normals. `views` have
// images. The same values for any number of threads.
SurfaceEvidence MeasureSurfaceEvidence(const ViewSet& views,
                                       const SurfaceEvidenceOptions& options,
                                       const Context& context,
                                       IndexedMesh* mesh);

}  // namespace octacut
