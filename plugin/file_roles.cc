#include "plugin/file_roles.h"

#include <system_error>

#include "colmap_io/files/atomic_files.h"
#include "core/base/check_option.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// The same for all paths to a file, whether it exists or not. Hard links are
// files of their own, since files are replaced and never written to.
fs::path Resolved(const fs::path& path) {
  const fs::path absolute = fs::absolute(path).lexically_normal();
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(absolute, error);
  return error ? absolute : canonical;
}

}  // namespace

void FileRoles::Read(const fs::path& path, const std::string& what) {
  if (!path.empty()) {
    files_.emplace(Resolved(path), what);
  }
}

void FileRoles::Write(const std::string& option,
                      const fs::path& path,
                      const std::string& what) {
  if (path.empty()) {
    return;
  }
  const auto [earlier, is_new] = files_.emplace(Resolved(path), what);
  CheckOption(is_new,
              option,
              path.string(),
              "must not be the same file as " + earlier->second);
  CheckFilePath(path);
}

}  // namespace octacut
