#include "core/evaluate/evaluate_mesh.h"

#include <Eigen/Geometry>

#include "core/raycast/ray_scene.h"
#include "core/raycast/render.h"

namespace octacut {
namespace {

Eigen::Vector3d MiddleOf(const IndexedMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      box.extend(mesh.positions[corner]);
    }
  }
  return box.center();
}

}  // namespace

void EvaluateMeshOptions::Check() const { reprojection.Check(); }

MeshEvaluation EvaluateMesh(const IndexedMesh& mesh,
                            const std::vector<View>& views,
                            const EvaluateMeshOptions& options,
                            const Context& context) {
  options.Check();
  const RayScene rays(mesh);
  std::vector<cv::Mat> depths;
  {
    Phase phase(context, "Depths", views.size());
    for (const View& view : views) {
      depths.push_back(
          RenderDepth(rays, view.camera, view.cam_from_world, context));
      phase.Advance();
    }
  }
  MeshEvaluation evaluation;
  evaluation.silhouettes = MeasureSilhouettes(rays, views, depths, context);
  if (options.photometric) {
    evaluation.reprojection = MeasureReprojection(
        views, depths, MiddleOf(mesh), options.reprojection, context);
    if (options.reprojection.keep_maps) {
      evaluation.view_support = MeasureViewSupport(
          views, evaluation.reprojection->maps, options.reprojection, context);
      evaluation.vertex_support = SupportOfPoints(mesh.positions,
                                                  views,
                                                  depths,
                                                  evaluation.reprojection->maps,
                                                  context);
    }
  }
  return evaluation;
}

}  // namespace octacut
