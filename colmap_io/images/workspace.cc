#include "colmap_io/images/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <tuple>

#include "colmap_io/files/require_folder.h"
#include "colmap_io/images/image_list.h"
#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/read_sparse_model.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

bool IsFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool HasModelFile(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name : {"cameras", "images", "points3D"}) {
    for (const char* extension : {".bin", ".txt"}) {
      if (fs::is_regular_file(folder / (std::string(name) + extension),
                              ignored)) {
        return true;
      }
    }
  }
  return false;
}

// "2" before "10", numbers before names.
bool ComesBefore(const fs::path& a, const fs::path& b) {
  const auto key = [](const fs::path& path) {
    const std::string name = path.filename().string();
    const bool number =
        !name.empty() && name.find_first_not_of("0123456789") == name.npos;
    return std::make_tuple(!number, number ? name.size() : 0, name);
  };
  return key(a) < key(b);
}

SparseModel LargestModel(const std::vector<fs::path>& folders,
                         fs::path* chosen,
                         const Context& context) {
  uint64_t most = 0;
  std::string first_error;
  std::vector<fs::path> readable;
  for (const fs::path& folder : folders) {
    try {
      const uint64_t count = CountSparseImages(folder);
      readable.push_back(folder);
      if (readable.size() == 1 || count > most) {
        most = count;
        *chosen = folder;
      }
    } catch (const InputError& error) {
      first_error = first_error.empty() ? error.what() : first_error;
      if (folders.size() > 1) {
        context.Warn(fmt::format(
            "{}: this model is ignored: {}", folder.string(), error.what()));
      }
    }
  }
  if (readable.empty()) {
    throw InputError(first_error);
  }
  if (folders.size() > 1) {
    context.Info(
        fmt::format("Found {} sparse models. Using {}, which has the most "
                    "images ({}). To use another one, pass its folder.",
                    folders.size(),
                    chosen->string(),
                    most));
  }
  return ReadSparseModel(*chosen);
}

fs::path FindMasks(const Workspace& workspace,
                   const WorkspaceOptions& options,
                   const Context& context) {
  const fs::path& given = options.mask_path;
  if (!given.empty()) {
    RequireFolder(given, "mask_path");
    return given;
  }
  fs::path here = workspace.path / "masks";
  if (IsFolder(here)) {
    return here;
  }
  if (workspace.is_dense_folder) {
    const fs::path absolute = fs::absolute(workspace.path / "").parent_path();
    for (const fs::path& parent :
         {absolute.parent_path(), absolute.parent_path().parent_path()}) {
      if (IsFolder(parent / "masks")) {
        context.Info(
            fmt::format("Using the masks in {}.", (parent / "masks").string()));
        return parent / "masks";
      }
    }
  }
  if (options.may_lack_masks) {
    return {};
  }
  throw InputError(fmt::format(
      "{}: the folder of masks does not exist; use --mask_path to name it, or "
      "make masks: octacut mask_extractor --workspace_path {}",
      here.string(),
      workspace.path.string()));
}

}  // namespace

std::vector<fs::path> FindModels(const fs::path& folder) {
  if (HasModelFile(folder)) {
    return {folder};
  }
  std::vector<fs::path> models;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.is_directory(ignored) && HasModelFile(entry.path())) {
      models.push_back(entry.path());
    }
  }
  std::sort(models.begin(), models.end(), ComesBefore);
  return models;
}

SparseModel ReadLargestModel(const fs::path& folder,
                             const std::string& name,
                             const Context& context,
                             fs::path* chosen) {
  const std::vector<fs::path> folders = FindModels(folder);
  if (folders.empty()) {
    throw InputError(
        fmt::format("{}: neither this folder nor its subfolders hold a sparse "
                    "model (cameras, images and points3D as .bin or .txt)",
                    name));
  }
  fs::path path;
  SparseModel model = LargestModel(folders, &path, context);
  if (chosen != nullptr) {
    *chosen = path;
  }
  return model;
}

Workspace OpenWorkspace(const fs::path& path,
                        const WorkspaceOptions& options,
                        const Context& context) {
  RequireFolder(path, "workspace_path");
  Workspace workspace;
  workspace.path = path;
  workspace.image_path =
      options.image_path.empty() ? path / "images" : options.image_path;
  if (options.needs_images && !IsFolder(workspace.image_path)) {
    throw InputError(fmt::format(
        "{}: the folder of images does not exist; use --image_path to name it",
        workspace.image_path.string()));
  }
  const bool given = !options.input_path.empty();
  const fs::path models = given ? options.input_path : path / "sparse";
  if (!IsFolder(models)) {
    throw InputError(
        fmt::format("{}: the folder of sparse models does not exist{}",
                    models.string(),
                    given ? "" : "; use --input_path to name it"));
  }
  workspace.model =
      ReadLargestModel(models, models.string(), context, &workspace.model_path);
  workspace.image_list_path = options.image_list_path;
  if (!options.image_list_path.empty()) {
    const size_t num_images = workspace.model.images.size();
    KeepListedImages(options.image_list_path, &workspace.model);
    context.Info(fmt::format("{}: using {} of the {} images of the model.",
                             options.image_list_path.string(),
                             workspace.model.images.size(),
                             num_images));
  }
  workspace.is_dense_folder = HasModelFile(path / "sparse") &&
                              std::all_of(workspace.model.cameras.begin(),
                                          workspace.model.cameras.end(),
                                          IsPinhole);
  if (options.needs_masks) {
    workspace.mask_path = FindMasks(workspace, options, context);
  }
  if (options.check) {
    options.check(workspace);
  }
  return workspace;
}

}  // namespace octacut
