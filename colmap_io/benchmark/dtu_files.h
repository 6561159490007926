// The MATLAB files that say which part of a scan of DTU is judged.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "core/benchmark/protocols/dtu.h"

namespace octacut {

struct DtuCrop {
  ObservabilityMask mask;
  Eigen::Vector4d plane;
};

// Reads ObsMask<scan>_10.mat (variables ObsMask, BB and Res) and
// Plane<scan>.mat (P), in any order, of any version that libmatio reads. Throws
// InputError that names the file and the variable, and OptionError (field
// crop_path) unless one of each is given.
DtuCrop ReadDtuCrop(const std::vector<std::filesystem::path>& paths);

}  // namespace octacut
