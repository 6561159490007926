// COLMAP's perspective camera models 0-16: table and checks.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace octacut {

// COLMAP's numbers of the models.
namespace camera_model {
inline constexpr int kSimplePinhole = 0;
inline constexpr int kPinhole = 1;
inline constexpr int kSimpleRadial = 2;
inline constexpr int kRadial = 3;
inline constexpr int kOpenCV = 4;
inline constexpr int kOpenCVFisheye = 5;
inline constexpr int kFullOpenCV = 6;
inline constexpr int kFOV = 7;
inline constexpr int kSimpleRadialFisheye = 8;
inline constexpr int kRadialFisheye = 9;
inline constexpr int kThinPrismFisheye = 10;
inline constexpr int kRadTanThinPrismFisheye = 11;
inline constexpr int kSimpleDivision = 12;
inline constexpr int kDivision = 13;
inline constexpr int kSimpleFisheye = 14;
inline constexpr int kFisheye = 15;
inline constexpr int kEUCM = 16;
inline constexpr int kEquirectangular = 17;  // known, but refused
inline constexpr int kCount = 17;            // of the models supported
}  // namespace camera_model

// A camera of a sparse model: one line of cameras.txt.
struct SparseCamera {
  uint32_t id = 0;
  int model_id = camera_model::kSimplePinhole;
  uint64_t width = 0;  // pixels
  uint64_t height = 0;
  std::vector<double> params;  // in the order of CameraModelInfo::params
};

struct CameraModelInfo {
  int id;
  std::string_view name;    // "SIMPLE_RADIAL"
  std::string_view params;  // "f,cx,cy,k": names of the parameters in order
  int num_params;
  int num_focal_lengths;  // 1 (f) or 2 (fx, fy); they come first
};

// The supported model of that number or name, or null.
const CameraModelInfo* FindCameraModel(int model_id);
const CameraModelInfo* FindCameraModel(std::string_view name);

// Same, but an InputError "<where>: ..." that names the model. `where` says
// what is being read: "cameras.bin: camera 7".
const CameraModelInfo& RequireCameraModel(int model_id, std::string_view where);
const CameraModelInfo& RequireCameraModel(std::string_view name,
                                          std::string_view where);

// Throws InputError unless the camera can be used: supported model, right
// number of finite parameters, positive focal lengths, sizes of 1 to
// 1,000,000 pixels and, for FOV and EUCM, parameters for which the formula is
// defined. `source` is the file's name for the message.
void CheckCamera(const SparseCamera& camera, std::string_view source);

// True when the model has no distortion: the camera is a pinhole as it is.
bool IsUndistorted(const SparseCamera& camera);

}  // namespace octacut
