#include "core/pipeline/shown_surface.h"

#include <algorithm>

#include "core/base/ramp.h"
#include "core/mesh/vertex_corners.h"
#include "core/pipeline/finish_mesh.h"
#include "core/refine/agreement.h"

namespace octacut {
namespace {

// Agreements up to which an object mirrors and from which on it does not: metal
// of twelve shapes has at most 0.30, all else with views near enough to be
// swept at least 0.42.
constexpr float kMirror = 0.33f;
constexpr float kMatt = 0.42f;

}  // namespace

ShownSurface MeasureShownSurface(const ViewSet& views,
                                 const LabeledVoxels& hull,
                                 const RefineOptions& options,
                                 const Context& context) {
  IndexedMesh mesh = PositionedMesh(
      hull, {.min_corner = Eigen::Vector3d::Zero(), .edge = 1}, context);
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& position : mesh.positions) {
    center += position / double(mesh.positions.size());
  }
  ShownSurface shown;
  const double pixel = PixelSize(views, center.cast<float>());
  if (!(pixel > 0)) {
    return shown;
  }
  const double half_voxel = 0.5 / double(hull.voxels.Resolution());
  const VertexCorners neighbors =
      FindVertexNeighbors(mesh.positions.size(), mesh.triangles);
  shown.agreement =
      MeasureAgreement({.views = views,
                        .neighbors = neighbors,
                        .pixel = pixel,
                        .options = options,
                        .scale = std::max(1.0, half_voxel / pixel),
                        .phase = "agreement of the views on the hull"},
                       context,
                       &mesh)
          .UpperDecile();
  shown.share = Ramp(float(shown.agreement), kMirror, kMatt);
  return shown;
}

}  // namespace octacut
