// One path for each file.
#pragma once

#include <filesystem>
#include <system_error>

namespace octacut {

// The same for all paths that lead to a file or folder, whether it exists or
// not: absolute, without dots and links. Hard links are files of their own.
inline std::filesystem::path ResolvedPath(const std::filesystem::path& path) {
  const std::filesystem::path absolute =
      std::filesystem::absolute(path).lexically_normal();
  std::error_code error;
  const std::filesystem::path canonical =
      std::filesystem::weakly_canonical(absolute, error);
  return error ? absolute : canonical;
}

}  // namespace octacut
