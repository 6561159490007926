// The files that mesh_comparer reads and writes.
#pragma once

#include <filesystem>
#include <vector>

#include "plugin/option_manager.h"

namespace octacut {

// Empty paths are no files.
struct ComparerPaths {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path reference;
  std::filesystem::path report;
  std::filesystem::path page;
  std::filesystem::path transform;
  std::filesystem::path transform_output;
  std::filesystem::path distance_folder;

  // The file with the distances of one of `inputs`.
  std::filesystem::path DistancesOf(const std::filesystem::path& input) const;
};

void DeclareComparerPaths(OptionManager& options, ComparerPaths* paths);

// Throws OptionError where a file would replace another, and InputError where
// one cannot be written. `crops` and `models` (folders of sparse models, or
// empty paths) are read, too. `aligns`: a transform will be found.
void CheckComparerPaths(const ComparerPaths& paths,
                        const std::vector<std::filesystem::path>& crops,
                        const std::vector<std::filesystem::path>& models,
                        bool aligns,
                        const OptionManager& options);

}  // namespace octacut
