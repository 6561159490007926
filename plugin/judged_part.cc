#include "plugin/judged_part.h"

#include <utility>

#include "colmap_io/images/undistorted_camera.h"
#include "core/base/check_option.h"
#include "core/scene/region.h"
#include "plugin/comparison_options.h"

namespace octacut {

void JudgedPartOptions::Check() const {
  seen.Check();
  CheckOption(input_views_path.empty() || !views_path.empty(),
              "input_views_path",
              input_views_path.string(),
              "needs views_path, a model of the same photographs in the frame "
              "of the reference");
}

void DeclareJudgedPartOptions(OptionManager& options,
                              JudgedPartOptions* judged) {
  options.Add(
      "views_path",
      &judged->views_path,
      "Folder of a sparse model in the frame of the reference. If given, only "
      "the part of the reference that its cameras see is compared.");
  options.Add(
      "input_views_path",
      &judged->input_views_path,
      "Folder of a sparse model of the same photographs in the frame of the "
      "compared meshes. If given, the meshes are first moved by the similarity "
      "transform that aligns its cameras with those of views_path. Default: "
      "none.");
  DeclareSeenOptions(options, &judged->seen);
  options.Add("bounding_box",
              &judged->bounding_box,
              "Box x0,y0,z0,x1,y1,z1 in the frame of the reference. If given, "
              "only the part of the reference inside it is compared.");
}

ReferenceFilter JudgedPart(const IndexedMesh& reference,
                           const SparseModel& views,
                           const JudgedPartOptions& options) {
  ReferenceFilter seen;
  if (!options.views_path.empty()) {
    std::vector<PosedCamera> cameras;
    cameras.reserve(views.images.size());
    for (const SparseImage& image : views.images) {
      cameras.push_back({UndistortedCamera(*views.FindCamera(image.camera_id)),
                         image.CamFromWorld()});
    }
    seen = SeenByCameras(reference, std::move(cameras), options.seen);
  }
  if (options.bounding_box.empty()) {
    return seen;
  }
  return [seen, box = BoundingBoxFromNumbers(options.bounding_box)](
             uint32_t triangle, const Eigen::Vector3d& point) {
    return box.contains(point) && (!seen || seen(triangle, point));
  };
}

}  // namespace octacut
