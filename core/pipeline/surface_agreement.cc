#include "core/pipeline/surface_agreement.h"

#include <algorithm>
#include <Eigen/Core>

#include "core/mesh/vertex_corners.h"
#include "core/pipeline/finish_mesh.h"
#include "core/refine/seen_surface.h"

namespace octacut {

MeasuredSurface MeasureSurface(const ViewSet& views,
                               const LabeledVoxels& surface,
                               double sample_width,
                               const char* phase,
                               const RefineOptions& options,
                               const Context& context) {
  MeasuredSurface measured{
      PositionedMesh(
          surface, {.min_corner = Eigen::Vector3d::Zero(), .edge = 1}, context),
      {}};
  IndexedMesh& mesh = measured.mesh;
  if (mesh.triangles.empty()) {
    return {};
  }
  const double pixel = PixelSizeAt(views, mesh);
  if (!(pixel > 0)) {
    return {};
  }
  const double width = sample_width / double(surface.voxels.Resolution());
  const VertexCorners neighbors =
      FindVertexNeighbors(mesh.positions.size(), mesh.triangles);
  measured.agreement = MeasureAgreement({.views = views,
                                         .neighbors = neighbors,
                                         .options = options,
                                         .pixel = pixel,
                                         .scale = std::max(1.0, width / pixel)},
                                        context,
                                        &mesh,
                                        phase);
  return measured;
}

}  // namespace octacut
