#include "colmap_io/model/camera_models.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/base/error.h"

namespace octacut {
namespace {

constexpr std::array<CameraModelInfo, camera_model::kCount> kModels = {{
    {0, "SIMPLE_PINHOLE", "f,cx,cy", 3, 1},
    {1, "PINHOLE", "fx,fy,cx,cy", 4, 2},
    {2, "SIMPLE_RADIAL", "f,cx,cy,k", 4, 1},
    {3, "RADIAL", "f,cx,cy,k1,k2", 5, 1},
    {4, "OPENCV", "fx,fy,cx,cy,k1,k2,p1,p2", 8, 2},
    {5, "OPENCV_FISHEYE", "fx,fy,cx,cy,k1,k2,k3,k4", 8, 2},
    {6, "FULL_OPENCV", "fx,fy,cx,cy,k1,k2,p1,p2,k3,k4,k5,k6", 12, 2},
    {7, "FOV", "fx,fy,cx,cy,omega", 5, 2},
    {8, "SIMPLE_RADIAL_FISHEYE", "f,cx,cy,k", 4, 1},
    {9, "RADIAL_FISHEYE", "f,cx,cy,k1,k2", 5, 1},
    {10, "THIN_PRISM_FISHEYE", "fx,fy,cx,cy,k1,k2,p1,p2,k3,k4,sx1,sy1", 12, 2},
    {11,
     "RAD_TAN_THIN_PRISM_FISHEYE",
     "fx,fy,cx,cy,k0,k1,k2,k3,k4,k5,p0,p1,s0,s1,s2,s3",
     16,
     2},
    {12, "SIMPLE_DIVISION", "f,cx,cy,k", 4, 1},
    {13, "DIVISION", "fx,fy,cx,cy,k", 5, 2},
    {14, "SIMPLE_FISHEYE", "f,cx,cy", 3, 1},
    {15, "FISHEYE", "fx,fy,cx,cy", 4, 2},
    {16, "EUCM", "fx,fy,cx,cy,alpha,beta", 6, 2},
}};

constexpr std::string_view kEquirectangularName = "EQUIRECTANGULAR";

[[noreturn]] void RefuseEquirectangular(std::string_view where) {
  throw InputError(
      fmt::format("{}: camera model EQUIRECTANGULAR (17) is not a perspective "
                  "camera model and is not supported",
                  where));
}

// The name of parameter `index` in "fx,fy,cx,cy".
std::string_view ParamName(const CameraModelInfo& info, size_t index) {
  std::string_view names = info.params;
  for (; index > 0; --index) names.remove_prefix(names.find(',') + 1);
  return names.substr(0, names.find(','));
}

void CheckParam(bool valid,
                const CameraModelInfo& info,
                const SparseCamera& camera,
                size_t index,
                std::string_view constraint,
                std::string_view source) {
  if (valid) return;
  throw InputError(fmt::format("{}: camera {}: {} parameter {} = {}: {}",
                               source,
                               camera.id,
                               info.name,
                               ParamName(info, index),
                               camera.params[index],
                               constraint));
}

void CheckSize(std::string_view field,
               uint64_t value,
               const SparseCamera& camera,
               std::string_view source) {
  constexpr uint64_t kLargest = 1'000'000;  // some ten times what files hold
  if (value >= 1 && value <= kLargest) {
    return;
  }
  throw InputError(fmt::format("{}: camera {}: {} = {}: must be 1 to {}",
                               source,
                               camera.id,
                               field,
                               value,
                               kLargest));
}

}  // namespace

const CameraModelInfo* FindCameraModel(int model_id) {
  if (model_id < 0 || model_id >= camera_model::kCount) return nullptr;
  return &kModels[size_t(model_id)];
}

const CameraModelInfo* FindCameraModel(std::string_view name) {
  for (const CameraModelInfo& info : kModels) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

const CameraModelInfo& RequireCameraModel(int model_id,
                                          std::string_view where) {
  if (model_id == camera_model::kEquirectangular) RefuseEquirectangular(where);
  const CameraModelInfo* info = FindCameraModel(model_id);
  if (info == nullptr) {
    throw InputError(
        fmt::format("{}: camera model {} is unknown (known: 0 to {})",
                    where,
                    model_id,
                    camera_model::kCount - 1));
  }
  return *info;
}

const CameraModelInfo& RequireCameraModel(std::string_view name,
                                          std::string_view where) {
  if (name == kEquirectangularName) RefuseEquirectangular(where);
  const CameraModelInfo* info = FindCameraModel(name);
  if (info == nullptr) {
    throw InputError(
        fmt::format("{}: camera model \"{}\" is unknown", where, name));
  }
  return *info;
}

void CheckCamera(const SparseCamera& camera, std::string_view source) {
  const CameraModelInfo& info = RequireCameraModel(
      camera.model_id, fmt::format("{}: camera {}", source, camera.id));
  CheckSize("width", camera.width, camera, source);
  CheckSize("height", camera.height, camera, source);
  if (camera.params.size() != size_t(info.num_params)) {
    throw InputError(
        fmt::format("{}: camera {}: {} parameters, but {} has {} ({})",
                    source,
                    camera.id,
                    camera.params.size(),
                    info.name,
                    info.num_params,
                    info.params));
  }
  const auto check =
      [&](bool valid, size_t index, std::string_view constraint) {
        CheckParam(valid, info, camera, index, constraint, source);
      };
  const std::vector<double>& params = camera.params;
  for (size_t i = 0; i < params.size(); ++i) {
    check(std::isfinite(params[i]), i, "must be finite");
    check(i >= size_t(info.num_focal_lengths) || params[i] > 0,
          i,
          "must be positive");
  }
  if (camera.model_id == camera_model::kFOV) {
    check(
        std::abs(params[4]) < std::numbers::pi, 4, "must be within (-pi, pi)");
  }
  if (camera.model_id == camera_model::kEUCM) {
    check(params[4] >= 0 && params[4] <= 1, 4, "must be within [0, 1]");
    check(params[5] > 0, 5, "must be positive");
  }
}

bool IsUndistorted(const SparseCamera& camera) {
  return camera.model_id == camera_model::kSimplePinhole ||
         camera.model_id == camera_model::kPinhole;
}

}  // namespace octacut
