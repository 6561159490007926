// The rules of the tree's structure, checked on the text of the sources:
//  - plugin -> colmap_io -> core: no include points up;
//  - inside core the folders are in the order of the data flow and include
//    only what comes before them; compare, evaluate, segment and synthetic
//    stand beside;
//  - core knows neither files nor image formats; OpenMesh, Ceres and Embree
//    stay each in the folder that wraps it;
//  - quoted includes are paths from the top of the tree, and exist;
//  - no source file is longer than 450 lines;
//  - no two headers outside tests define types of the same name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace octacut {

inline constexpr size_t kMaxFileLines = 450;

// Violations in all .h and .cc files of core, colmap_io, plugin and tests
// below `root`, each "file:line: what is wrong", sorted.
std::vector<std::string> FindRuleViolations(const std::filesystem::path& root);

// How many files FindRuleViolations looks at.
size_t CountSourceFiles(const std::filesystem::path& root);

}  // namespace octacut
