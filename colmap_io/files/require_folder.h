// That a folder which an option names is there.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string_view>
#include <system_error>

#include "core/base/error.h"

namespace octacut {

// Throws InputError where it is not.
inline void RequireFolder(const std::filesystem::path& path,
                          std::string_view option) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) {
    throw InputError(
        fmt::format("{} {}: no such folder", option, path.string()));
  }
}

}  // namespace octacut
