#include "colmap_io/model/sparse_values.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace octacut {

void SetPose(const double pose[7], std::string_view where, SparseImage* image) {
  static constexpr const char* kFields[7] = {
      "qw", "qx", "qy", "qz", "tx", "ty", "tz"};
  for (int i = 0; i < 7; ++i) {
    if (!std::isfinite(pose[i])) {
      throw InputError(fmt::format("{} ({}): {} = {}: must be finite",
                                   where,
                                   image->name,
                                   kFields[i],
                                   pose[i]));
    }
  }
  Eigen::Quaterniond rotation(pose[0], pose[1], pose[2], pose[3]);
  const double norm = rotation.coeffs().stableNorm();
  if (!(norm > std::numeric_limits<double>::min()) || !std::isfinite(norm)) {
    throw InputError(
        fmt::format("{} ({}): quaternion qw qx qy qz = {} {} {} {}: cannot be "
                    "normalized",
                    where,
                    image->name,
                    pose[0],
                    pose[1],
                    pose[2],
                    pose[3]));
  }
  if (std::abs(norm - 1) > 4 * std::numeric_limits<double>::epsilon()) {
    rotation.coeffs() /= norm;
  }
  image->rotation = rotation;
  image->translation = {pose[4], pose[5], pose[6]};
}

void CheckObservation(const SparseObservation& observation,
                      size_t index,
                      std::string_view file,
                      uint32_t image_id) {
  if (std::isfinite(observation.x) && std::isfinite(observation.y)) return;
  throw InputError(
      fmt::format("{}: image {}: observation {} at ({}, {}): must be finite",
                  file,
                  image_id,
                  index,
                  observation.x,
                  observation.y));
}

void CheckPointValues(const SparsePoint& point, std::string_view file) {
  if (point.xyz.allFinite()) return;
  throw InputError(fmt::format("{}: point {}: xyz = {} {} {}: must be finite",
                               file,
                               point.id,
                               point.xyz.x(),
                               point.xyz.y(),
                               point.xyz.z()));
}

}  // namespace octacut
