#include "colmap_io/images/workspace_files.h"

#include <system_error>
#include <utility>

#include "colmap_io/images/mask_file.h"
#include "colmap_io/images/mask_list.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

void AddIfFile(fs::path path,
               const std::string& what,
               std::vector<WorkspaceFile>* files) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) {
    files->push_back({std::move(path), what});
  }
}

}  // namespace

std::vector<WorkspaceFile> FilesOf(const Workspace& workspace) {
  std::vector<WorkspaceFile> files;
  for (const SparseImage& image : workspace.model.images) {
    AddIfFile(workspace.image_path / image.name, "a photograph", &files);
    if (!workspace.mask_path.empty()) {
      const auto mask =
          FindMaskFile(workspace.mask_path, image.name, workspace.image_path);
      AddIfFile(mask.value_or(fs::path()), "a mask", &files);
    }
  }
  if (!workspace.mask_path.empty()) {
    AddIfFile(
        workspace.mask_path / kMaskListName, "the list of the masks", &files);
  }
  for (const char* name :
       {"cameras", "images", "points3D", "rigs", "frames", "project"}) {
    for (const char* extension : {".bin", ".txt", ".ini"}) {
      AddIfFile(workspace.model_path / (std::string(name) + extension),
                "a file of the sparse model",
                &files);
    }
  }
  AddIfFile(workspace.image_list_path, "the list of images", &files);
  return files;
}

}  // namespace octacut
