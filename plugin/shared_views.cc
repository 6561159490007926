#include "plugin/shared_views.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

#include "plugin/transform_file.h"

namespace octacut {
namespace {

// By how much the centres of the cameras may be apart, relative to their
// distances from their mean. Models of the same photographs agree to a
// thousandth; in those of different arrangements the centres are as far apart
// as they are from their mean.
constexpr double kLargestDisagreement = 0.05;

}  // namespace

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
  if (alignment.rms > kLargestDisagreement * alignment.spread) {
    context.Warn(figures +
                 ". The cameras of the two models probably differ; the "
                 "comparison may be meaningless.");
  } else {
    context.Info(figures + ".");
  }
  return alignment;
}

std::string SharedViewsLine(const SharedCameraAlignment& alignment,
                            const std::filesystem::path& model_path,
                            const std::filesystem::path& reference_path) {
  return fmt::format(
      "Transform: the compared meshes were moved by the cameras of {} "
      "photographs that {} and {} share; their centres agree to {:.3g} (root "
      "mean square).",
      alignment.num_inliers,
      model_path.string(),
      reference_path.string(),
      alignment.rms);
}

Json SharedViewsToJson(const SharedCameraAlignment& alignment) {
  return {
      {"reference_from_input", TransformToJson(alignment.reference_from_model)},
      {"num_cameras", alignment.num_inliers},
      {"rms", alignment.rms}};
}

}  // namespace octacut
