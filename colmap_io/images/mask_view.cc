#include "colmap_io/images/mask_view.h"

#include <opencv2/core.hpp>
#include <string>
#include <utility>

#include "colmap_io/images/image_file.h"
#include "colmap_io/images/reduce_mask.h"
#include "colmap_io/model/camera_projector.h"

namespace octacut {
namespace {

constexpr int kReducedMaskSize = 640;

}  // namespace

MaskView ReadMaskView(const ViewFiles& files,
                      const Frame& frame,
                      const MaskCameras& mask_cameras) {
  MaskView result;
  const cv::Mat mask = ReadMask(files.mask_file);
  result.camera = mask_cameras.Find(*files.image,
                                    *files.camera,
                                    {uint64_t(mask.cols), uint64_t(mask.rows)},
                                    files.mask_file.string());
  const cv::Mat object = mask >= kObjectThreshold;
  result.content = ContentOfMask(object);
  if (result.content != MaskContent::kOutline) {
    return result;
  }
  result.object_all_around = BorderIsObject(object);
  const bool own = result.camera.model_id == files.camera->model_id &&
                   result.camera.params == files.camera->params;
  ReducedMask reduced = ReduceMask(mask,
                                   result.camera,
                                   own ? frame : FrameOfCamera(result.camera),
                                   kReducedMaskSize);
  View& view = result.view;
  view.name = files.image->name;
  view.camera = reduced.camera;
  view.cam_from_world = files.image->CamFromWorld();
  view.mask = std::move(reduced.mask);
  view.scale =
      reduced.camera.fx / CameraProjector(result.camera).Intrinsics().fx;
  return result;
}

}  // namespace octacut
