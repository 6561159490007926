// Which files a workspace consists of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_io/images/workspace.h"

namespace octacut {

struct WorkspaceFile {
  std::filesystem::path path;
  std::string what;  // for example "a photograph"
};

// The photographs of the model's images and their masks, the list beside the
// masks, the files of the model and the list of images, as far as they exist.
// Throws as FindMaskFile does.
std::vector<WorkspaceFile> FilesOf(const Workspace& workspace);

}  // namespace octacut
