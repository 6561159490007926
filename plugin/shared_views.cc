#include "plugin/shared_views.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

namespace octacut {

SharedCameraAlignment AlignBySharedViews(const SparseModel& model,
                                         const SparseModel& reference,
                                         const Context& context) {
  std::map<std::string, Rigid3d> in_reference;
  for (const SparseImage& image : reference.images) {
    in_reference.emplace(image.name, image.CamFromWorld());
  }
  std::vector<SharedCamera> cameras;
  for (const SparseImage& image : model.images) {
    const auto found = in_reference.find(image.name);
    if (found != in_reference.end()) {
      cameras.push_back({image.CamFromWorld(), found->second});
    }
  }
  SharedCameraAlignment alignment = AlignSharedCameras(cameras);
  const std::string figures = fmt::format(
      "{} photographs are in both models; the camera centres of {} of them "
      "agree, with a root mean square of {:.3g} units of the reference",
      cameras.size(),
      alignment.num_inliers,
      alignment.rms);
  if (2 * alignment.num_inliers < cameras.size()) {
    context.Warn(figures +
                 ". The models hardly have the same cameras; the comparison "
                 "may be meaningless.");
  } else {
    context.Info(figures + ".");
  }
  return alignment;
}

}  // namespace octacut
