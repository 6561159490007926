#include "plugin/file_roles.h"

#include <system_error>

#include "colmap_io/files/atomic_files.h"
#include "core/base/check_option.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Also of files that do not exist yet, and through links.
bool AreSame(const fs::path& one, const fs::path& other) {
  std::error_code ignored;
  return fs::equivalent(one, other, ignored) ||
         fs::weakly_canonical(fs::absolute(one), ignored) ==
             fs::weakly_canonical(fs::absolute(other), ignored);
}

}  // namespace

void FileRoles::Read(const fs::path& path, const std::string& what) {
  if (!path.empty()) {
    files_.push_back({path, what});
  }
}

void FileRoles::Write(const std::string& option,
                      const fs::path& path,
                      const std::string& what) {
  if (path.empty()) {
    return;
  }
  for (const Named& file : files_) {
    CheckOption(!AreSame(path, file.path),
                option.c_str(),
                path.string(),
                "must not be the same file as " + file.what);
  }
  CheckFilePath(path);
  files_.push_back({path, what});
}

}  // namespace octacut
