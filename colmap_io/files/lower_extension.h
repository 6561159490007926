// The extension of a file's name, by which octacut knows formats.
#pragma once

#include <cctype>
#include <filesystem>
#include <string>

namespace octacut {

// With its dot, in lower case; empty where there is none.
inline std::string LowerExtension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    c = char(std::tolower(static_cast<unsigned char>(c)));
  }
  return extension;
}

}  // namespace octacut
