// A file that appears whole or not at all.
#pragma once

#include <filesystem>
#include <fstream>

namespace octacut {

// Writes to a temporary file in the folder of `path` and renames it on
// Commit. The temporary is removed when the object goes without a commit. A
// path that is a symbolic link has the file it leads to replaced.
class AtomicFile {
 public:
  // Throws InputError naming the path when the folder is missing or cannot be
  // written to, or when `path` is there but no regular file.
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& Stream() { return stream_; }

  // Throws InputError when anything could not be written (a full disk).
  void Commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
};

// To be asked before any long work whose result goes to `path`: throws as the
// constructor of AtomicFile does, and leaves everything as it was.
void CheckFilePath(const std::filesystem::path& path);

}  // namespace octacut
