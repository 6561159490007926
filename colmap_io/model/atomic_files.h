// Files that take their names only once all of them are complete.
// Private to this folder.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace octacut {

// Writes to temporary files beside their goals; Commit() renames them. What
// is not committed is removed again.
class AtomicFiles {
 public:
  AtomicFiles() = default;
  ~AtomicFiles();
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;

  // Throws Error when the file cannot be written.
  void Write(const std::filesystem::path& path,
             const std::function<void(std::ostream&)>& write);

  // Throws Error when a file cannot be renamed.
  void Commit();

 private:
  struct Pending {
    std::filesystem::path temporary;
    std::filesystem::path goal;
  };
  std::vector<Pending> pending_;
};

}  // namespace octacut
