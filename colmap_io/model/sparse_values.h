// Checks of single values that the binary and the text reader share.
// Private to this folder.
#pragma once

#include <cstddef>
#include <string_view>

#include "colmap_io/model/sparse_model.h"

namespace octacut {

// Sets the image's pose from qw qx qy qz tx ty tz and normalizes the
// quaternion. Throws InputError "<where> (<name>): ..." when a value is not
// finite or the quaternion is zero. A quaternion of unit length to within
// rounding stays as it is, so that a model survives reading and writing.
void SetPose(const double pose[7], std::string_view where, SparseImage* image);

void CheckObservation(const SparseObservation& observation,
                      size_t index,
                      std::string_view file,
                      uint32_t image_id);

void CheckPointValues(const SparsePoint& point, std::string_view file);

}  // namespace octacut
