#include "colmap_io/model/atomic_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Creates a new file beside `path` under a name that nobody else has.
fs::path CreateTemporary(const fs::path& path) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const fs::path temporary =
        path.parent_path() /
        fmt::format(
            ".{}.{}-{}.tmp", path.filename().string(), getpid(), attempt);
    // x: fails when the file exists.
    if (std::FILE* file = std::fopen(temporary.c_str(), "wbx")) {
      std::fclose(file);
      return temporary;
    }
    if (errno != EEXIST) break;
  }
  throw Error(fmt::format(
      "{}: cannot be created: {}", path.string(), std::strerror(errno)));
}

}  // namespace

AtomicFiles::~AtomicFiles() {
  std::error_code ignored;
  for (const Pending& file : pending_) fs::remove(file.temporary, ignored);
}

void AtomicFiles::Write(const fs::path& path,
                        const std::function<void(std::ostream&)>& write) {
  pending_.push_back({CreateTemporary(path), path});
  std::ofstream stream(pending_.back().temporary,
                       std::ios::binary | std::ios::trunc);
  if (stream) write(stream);
  stream.close();
  if (!stream) {
    throw Error(fmt::format("{}: cannot be written (is the disk full?)",
                            path.string()));
  }
}

void AtomicFiles::Commit() {
  for (const Pending& file : pending_) {
    std::error_code error;
    fs::rename(file.temporary, file.goal, error);
    if (error) {
      throw Error(fmt::format(
          "{}: cannot be written: {}", file.goal.string(), error.message()));
    }
  }
  pending_.clear();
}

}  // namespace octacut
