// The parts of a COLMAP workspace.
//
//   dense folder  W/images, W/sparse/{cameras,images,points3D}: the output of
//                 image_undistorter (W may be dense/<i> of COLMAP 4)
//   project       W/images, W/sparse/<i>/: the mapper's models
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "colmap_io/model/sparse_model.h"
#include "core/base/context.h"

namespace octacut {

struct Workspace;

// Empty: the default place in the workspace.
struct WorkspaceOptions {
  std::filesystem::path image_path;  // folder of images; default W/images
  std::filesystem::path input_path;  // folder of the model, or of models
  std::filesystem::path mask_path;   // folder of masks; default W/masks, in a
                                     // dense folder also ../masks, ../../masks
  // Text file with the names of the images to use; default: all.
  std::filesystem::path image_list_path;
  bool needs_images = true;     // false: there may be no folder of images
  bool needs_masks = true;      // false: the folder of masks is not looked for
  bool may_lack_masks = false;  // true: there need not be a folder of masks
  // Called by OpenWorkspace with its result, if any, before more is read.
  std::function<void(const Workspace&)> check;
};

struct Workspace {
  std::filesystem::path path;
  std::filesystem::path image_path;
  std::filesystem::path model_path;
  std::filesystem::path mask_path;
  std::filesystem::path image_list_path;  // empty: all images are used
  // The model lies in `sparse` itself, as image_undistorter leaves it.
  bool is_dense_folder = false;
  SparseModel model;
};

// Finds the parts and reads the model, as ReadLargestModel does. Throws
// InputError naming the part that is missing.
Workspace OpenWorkspace(const std::filesystem::path& path,
                        const WorkspaceOptions& options,
                        const Context& context);

// The model in `folder` or, of several one level below it, the one with the
// most registered images (the first of equals), which context.Info names and
// `chosen` gets. Errors call the folder `name` where it holds no model.
SparseModel ReadLargestModel(const std::filesystem::path& folder,
                             const std::string& name,
                             const Context& context,
                             std::filesystem::path* chosen = nullptr);

// Folders below `folder` (itself and one level down) that hold a model, in
// the order of their names; numbers in the order of their values.
std::vector<std::filesystem::path> FindModels(
    const std::filesystem::path& folder);

}  // namespace octacut
