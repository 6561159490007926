#include "colmap_io/files/atomic_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const fs::path& path, std::string_view reason) {
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
    Fail(path, "is not a regular file");
  }
  if (path.filename().empty()) {
    Fail(path, "is not a file name");
  }
  const fs::path folder =
      path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    Fail(path, "its folder does not exist");
  }
  if (!fs::is_symlink(fs::symlink_status(path, error))) {
    return path;
  }
  fs::path target = fs::canonical(path, error);
  if (error) {
    Fail(path, "is a symbolic link that leads to no file");
  }
  return target;
}

// Creates a file that did not exist, with the permissions of any new file.
fs::path CreateTemporary(const fs::path& target) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    fs::path temporary = target;
    temporary.replace_filename(fmt::format(
        ".{}.{}-{}.tmp", target.filename().string(), ::getpid(), attempt));
    const int file =
        ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0666);
    if (file >= 0) {
      ::close(file);
      return temporary;
    }
    if (errno != EEXIST) {
      Fail(target, std::generic_category().message(errno));
    }
  }
  Fail(target, "there are too many temporary files in its folder");
}

}  // namespace

AtomicFiles::~AtomicFiles() {
  std::error_code ignored;
  for (const Pending& file : pending_) {
    fs::remove(file.temporary, ignored);
  }
}

void AtomicFiles::Write(const fs::path& path,
                        const std::function<void(std::ostream&)>& write) {
  Pending& file = pending_.emplace_back();
  file.target = ResolveTarget(path);
  file.temporary = CreateTemporary(file.target);
  std::ofstream stream(file.temporary, std::ios::binary | std::ios::trunc);
  if (stream) {
    NamingErrors(path.string(), [&] { write(stream); });
  }
  stream.close();
  if (!stream) {
    Fail(path, "the disk may be full");
  }
}

void AtomicFiles::Commit() {
  for (Pending& file : pending_) {
    std::error_code error;
    fs::rename(file.temporary, file.target, error);
    if (error) {
      Fail(file.target, error.message());
    }
    file.temporary.clear();
  }
  pending_.clear();
}

void WriteFile(const fs::path& path,
               const std::function<void(std::ostream&)>& write) {
  AtomicFiles files;
  files.Write(path, write);
  files.Commit();
}

void CheckFilePath(const fs::path& path) {
  // Creates and removes the temporary file: the surest way to know.
  AtomicFiles().Write(path, [](std::ostream&) {});
}

}  // namespace octacut
