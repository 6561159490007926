// The files of one run of a command by what they are, so that none of them
// replaces another.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "colmap_io/images/workspace.h"
#include "plugin/option_manager.h"

namespace octacut {

class FileRoles {
 public:
  // With the project file, if `options` were read from one.
  explicit FileRoles(const OptionManager& options);

  // An empty path is no file. `what` is, for example, "the mesh to texture".
  void Read(const std::filesystem::path& path, const std::string& what);
  // Throws OptionError "<option> = <path>: must not be the same file as <what>"
  // where the path leads to a file that was named before, and InputError where
  // the file cannot be written. To be asked before any long work.
  void Write(const std::string& option,
             const std::filesystem::path& path,
             const std::string& what);

  // Throws the same OptionError where a file to be written is one of FilesOf.
  void RequireApartFrom(const Workspace& workspace) const;
  // Has OpenWorkspace ask RequireApartFrom, of all files named so far.
  void Guard(WorkspaceOptions* workspace) const;

 private:
  struct Role {
    std::string what;
    std::string option;          // empty: the file is read
    std::filesystem::path path;  // as it was given
  };
  // By the path without links and dots.
  std::map<std::filesystem::path, Role> files_;
};

}  // namespace octacut
