// A folder for output.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "core/base/error.h"

namespace octacut {

// With the folders above it. Throws Error if it is not there afterwards.
inline void CreateFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw Error(fmt::format("{}: the folder cannot be created: {}",
                            folder.string(),
                            error.message()));
  }
}

}  // namespace octacut
