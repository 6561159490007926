#include "plugin/run_picture.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_io/images/write_image.h"
#include "core/raycast/render.h"

namespace octacut {
namespace {

// Wide enough to judge a surface by, small enough to look at.
constexpr int kPictureSide = 600;

size_t ViewOfMostObject(const Scene& scene) {
  size_t best = 0;
  int most = -1;
  for (size_t i = 0; i < scene.views.size(); ++i) {
    const int count = cv::countNonZero(scene.views[i].mask >= kObjectThreshold);
    if (count > most) {
      most = count;
      best = i;
    }
  }
  return best;
}

// The view at a scale of `factor`.
PinholeCamera Scaled(const PinholeCamera& camera, double factor) {
  PinholeCamera scaled = camera;
  scaled.width = std::max(1, int(camera.width * factor));
  scaled.height = std::max(1, int(camera.height * factor));
  const double x = double(scaled.width) / camera.width;
  const double y = double(scaled.height) / camera.height;
  scaled.fx *= x;
  scaled.cx *= x;
  scaled.fy *= y;
  scaled.cy *= y;
  return scaled;
}

}  // namespace

void WriteRunPicture(const std::filesystem::path& path,
                     const Scene& scene,
                     const IndexedMesh& mesh,
                     const Context& context,
                     AtomicFiles* files) {
  const Phase phase(context, "picture");
  const View& view = scene.views[ViewOfMostObject(scene)];
  const PinholeCamera camera = Scaled(
      view.camera,
      double(kPictureSide) / std::max(view.camera.width, view.camera.height));
  const RayScene rays(mesh);
  RenderOptions clay;
  RenderOptions colored;
  colored.use_vertex_colors = true;
  cv::Mat photograph;
  cv::resize(view.image,
             photograph,
             cv::Size(camera.width, camera.height),
             0,
             0,
             cv::INTER_AREA);
  cv::Mat picture;
  cv::hconcat(
      std::vector<cv::Mat>{
          photograph,
          RenderShaded(mesh, rays, camera, view.cam_from_world, clay, context),
          RenderShaded(
              mesh, rays, camera, view.cam_from_world, colored, context)},
      picture);
  WriteImage(path, picture, files);
}

}  // namespace octacut
