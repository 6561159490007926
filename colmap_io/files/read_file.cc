#include "colmap_io/files/read_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <system_error>

#include "core/base/error.h"

namespace octacut {

std::string ReadFile(const std::filesystem::path& path) {
  std::error_code error;
  const uintmax_t size = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  std::string bytes;
  if (!error && stream) {
    bytes.resize(size);
    stream.read(bytes.data(), std::streamsize(size));
  }
  if (error || !stream) {
    throw InputError(fmt::format("{}: the file cannot be read", path.string()));
  }
  return bytes;
}

}  // namespace octacut
