#include "plugin/file_roles.h"

#include <algorithm>
#include <system_error>

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/files/resolved_path.h"
#include "colmap_io/images/workspace_files.h"
#include "core/base/check_option.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

void CheckIsApart(bool is_apart,
                  const std::string& option,
                  const fs::path& path,
                  const std::string& what) {
  CheckOption(
      is_apart, option, path.string(), "must not be the same file as " + what);
}

}  // namespace

FileRoles::FileRoles(const OptionManager& options) {
  Read(options.ProjectPath(), "the project file");
}

void FileRoles::Read(const fs::path& path, const std::string& what) {
  if (!path.empty()) {
    files_.emplace(ResolvedPath(path), Role{what, "", path});
  }
}

void FileRoles::Write(const std::string& option,
                      const fs::path& path,
                      const std::string& what) {
  if (path.empty()) {
    return;
  }
  const auto [earlier, is_new] =
      files_.emplace(ResolvedPath(path), Role{what, option, path});
  CheckIsApart(is_new, option, path, earlier->second.what);
  CheckFilePath(path);
}

void FileRoles::RequireApartFrom(const Workspace& workspace) const {
  const bool replaces_any =
      std::any_of(files_.begin(), files_.end(), [](const auto& file) {
        std::error_code ignored;
        return !file.second.option.empty() && fs::exists(file.first, ignored);
      });
  if (!replaces_any) {
    return;  // to resolve the paths of many files takes a while
  }
  for (const WorkspaceFile& file : FilesOf(workspace)) {
    const auto found = files_.find(ResolvedPath(file.path));
    if (found != files_.end()) {
      const Role& role = found->second;
      CheckIsApart(role.option.empty(),
                   role.option,
                   role.path,
                   file.what + " of the workspace");
    }
  }
}

void FileRoles::Guard(WorkspaceOptions* workspace) const {
  workspace->check = [files = *this](const Workspace& opened) {
    files.RequireApartFrom(opened);
  };
}

}  // namespace octacut
