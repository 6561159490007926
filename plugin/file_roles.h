// The files of one run of a command by what they are, so that none of them
// replaces another.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace octacut {

class FileRoles {
 public:
  // An empty path is no file. `what` is, for example, "the mesh to texture".
  void Read(const std::filesystem::path& path, const std::string& what);
  // Throws OptionError "<option> = <path>: must not be the same file as <what>"
  // where the path leads to a file that was named before, and InputError where
  // the file cannot be written. To be asked before any long work.
  void Write(const std::string& option,
             const std::filesystem::path& path,
             const std::string& what);

 private:
  // By the path without links and dots.
  std::map<std::filesystem::path, std::string> files_;
};

}  // namespace octacut
