// Cuts of one crust that grows, each from the state of the last one.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace octacut {

// One object an instance that is larger than the one before: seconds of the cut
// from nothing and of the one that goes on; `equal` if both give the same.
// Instances are files of one level, each with all voxels of the one before.
std::vector<nlohmann::json> MeasureGrowing(
    const std::vector<std::string>& instance_paths, int num_threads, bool lean);

}  // namespace octacut
