#include "core/benchmark/evaluate/evaluate_mesh.h"

#include "core/mesh/bounding_box.h"
#include "core/raycast/ray_scene.h"
#include "core/raycast/render.h"

namespace octacut {
void EvaluateMeshOptions::Check() const { reprojection.Check(); }

MeshEvaluation EvaluateMesh(const IndexedMesh& mesh,
                            const std::vector<View>& views,
                            const EvaluateMeshOptions& options,
                            const Context& context) {
  options.Check();
  const RayScene rays(mesh);
  std::vector<cv::Mat> depths;
  {
    Phase phase(context, "depths of the mesh", views.size());
    for (const View& view : views) {
      depths.push_back(
          RenderDepth(rays, view.camera, view.cam_from_world, context));
      phase.Advance();
    }
  }
  MeshEvaluation evaluation;
  evaluation.silhouettes = MeasureSilhouettes(rays, views, depths, context);
  if (options.photometric) {
    evaluation.reprojection = MeasureReprojection(views,
                                                  depths,
                                                  BoxOfTriangles(mesh).center(),
                                                  options.reprojection,
                                                  context);
    if (options.reprojection.keep_maps) {
      evaluation.view_support =
          MeasureViewSupport(views, evaluation.reprojection->maps, context);
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
