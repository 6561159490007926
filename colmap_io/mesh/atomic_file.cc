#include "colmap_io/mesh/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const fs::path& path, const char* reason) {
  throw InputError(
      fmt::format("{}: cannot be written: {}", path.string(), reason));
}

// The file itself, where `path` may be a symbolic link to it.
fs::path ResolveTarget(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) {
    Fail(path, "is a folder");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    Fail(path, "is no regular file");
  }
  if (path.filename().empty()) {
    Fail(path, "is no file name");
  }
  const fs::path folder =
      path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    Fail(path, "its folder does not exist");
  }
  if (!fs::is_symlink(fs::symlink_status(path, error))) {
    return path;
  }
  const fs::path target = fs::canonical(path, error);
  return error ? path : target;
}

// Creates a file that did not exist, with the permissions of any new file.
fs::path CreateTemporary(const fs::path& path) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    fs::path temporary = path;
    temporary.replace_filename(fmt::format(
        ".{}.{}-{}.tmp", path.filename().string(), ::getpid(), attempt));
    const int file =
        ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0666);
    if (file >= 0) {
      ::close(file);
      return temporary;
    }
    if (errno != EEXIST) {
      Fail(path, std::strerror(errno));
    }
  }
  Fail(path, "too many temporary files beside it");
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path)
    : path_(ResolveTarget(path)), temporary_(CreateTemporary(path_)) {
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) {
    stream_.close();
    std::error_code ignored;
    fs::remove(temporary_, ignored);
  }
}

void AtomicFile::Commit() {
  stream_.close();
  if (!stream_) {
    Fail(path_, "the disk may be full");
  }
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error) {
    Fail(path_, error.message().c_str());
  }
  temporary_.clear();
}

void CheckFilePath(const fs::path& path) {
  // Creates and removes the temporary file: the surest way to know.
  const AtomicFile probe(path);
}

}  // namespace octacut
