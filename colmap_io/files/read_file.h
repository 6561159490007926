// The bytes of a whole file.
#pragma once

#include <filesystem>
#include <string>

namespace octacut {

// Throws InputError that names the file when it cannot be read or is a folder.
std::string ReadFile(const std::filesystem::path& path);

}  // namespace octacut
