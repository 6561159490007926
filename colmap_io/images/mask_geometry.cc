#include "colmap_io/images/mask_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/read_sparse_model.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

bool HasSize(const SparseCamera& camera, const ImageSize& size) {
  return camera.width == size.width && camera.height == size.height;
}

SparseCamera ToSparseCamera(const PinholeCamera& camera) {
  SparseCamera result;
  result.model_id = camera_model::kPinhole;
  result.width = uint64_t(camera.width);
  result.height = uint64_t(camera.height);
  result.params = {camera.fx, camera.fy, camera.cx, camera.cy};
  return result;
}

}  // namespace

MaskCameras::MaskCameras(const Workspace& workspace,
                         MaskGeometry geometry,
                         const fs::path& original_path)
    : workspace_(workspace),
      geometry_(geometry),
      original_path_(original_path) {
  if (original_path.empty()) {
    return;
  }
  if (!workspace.is_dense_folder) {
    throw InputError(fmt::format(
        "original_path {}: not needed, because the workspace {} is not a dense "
        "folder; its own model is that of the original photographs",
        original_path.string(),
        workspace.path.string()));
  }
  if (FindModels(original_path).empty()) {
    throw InputError(
        fmt::format("original_path {}: the folder holds no sparse model",
                    original_path.string()));
  }
}

SparseCamera MaskCameras::Find(const SparseImage& image,
                               const SparseCamera& camera,
                               const ImageSize& mask_size,
                               const std::string& mask_name) const {
  // The images of a dense folder are undistorted, those of a project original.
  const MaskGeometry own = workspace_.is_dense_folder
                               ? MaskGeometry::kUndistorted
                               : MaskGeometry::kOriginal;
  const bool own_allowed = geometry_ == MaskGeometry::kAuto ||
                           geometry_ == own ||
                           (!workspace_.is_dense_folder && IsPinhole(camera));
  if (own_allowed && HasSize(camera, mask_size)) {
    return camera;
  }
  const bool other_allowed = geometry_ != own;
  if (other_allowed) {
    const std::vector<SparseCamera> others = OtherCameras(image, camera);
    for (const SparseCamera& other : others) {
      if (HasSize(other, mask_size)) {
        return other;
      }
    }
    if (others.empty() && workspace_.is_dense_folder) {
      throw InputError(fmt::format(
          "{}: the mask has {}x{} pixels, but image {} has {}x{}. If the mask "
          "was made for the original photograph, use --original_path to name "
          "the sparse model of the original photographs",
          mask_name,
          mask_size.width,
          mask_size.height,
          image.name,
          camera.width,
          camera.height));
    }
  }
  throw InputError(fmt::format(
      "{}: the mask has {}x{} pixels, which is neither the size of image {} "
      "({}x{}) nor its original or undistorted size (--mask_geometry {})",
      mask_name,
      mask_size.width,
      mask_size.height,
      image.name,
      camera.width,
      camera.height,
      geometry_ == MaskGeometry::kAuto       ? "auto"
      : geometry_ == MaskGeometry::kOriginal ? "original"
                                             : "undistorted"));
}

std::vector<SparseCamera> MaskCameras::OtherCameras(
    const SparseImage& image, const SparseCamera& camera) const {
  const CamerasByName& others = OtherCameras();
  const auto found = others.find(image.name);
  if (found != others.end()) {
    return found->second;
  }
  if (!workspace_.is_dense_folder) {
    return {ToSparseCamera(UndistortedCamera(camera))};
  }
  return {};
}

const MaskCameras::CamerasByName& MaskCameras::OtherCameras() const {
  std::call_once(once_, [this] { ReadOtherCameras(); });
  return others_;
}

std::vector<fs::path> MaskCameras::OtherModels() const {
  if (!original_path_.empty()) {
    return FindModels(original_path_);
  }
  const fs::path here = fs::absolute(workspace_.path / "").parent_path();
  const bool is_dense = workspace_.is_dense_folder;
  std::vector<fs::path> folders;
  if (is_dense) {
    folders = {here.parent_path() / "sparse",
               here.parent_path().parent_path() / "sparse"};
  } else {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(here / "dense", ignored)) {
      folders.push_back(entry.path() / "sparse");
    }
    std::sort(folders.begin(), folders.end());
    folders.insert(folders.begin(), here / "dense" / "sparse");
  }
  std::vector<fs::path> models;
  for (const fs::path& folder : folders) {
    const std::vector<fs::path> found = FindModels(folder);
    models.insert(models.end(), found.begin(), found.end());
  }
  // sparse/1 and dense/1/sparse belong together.
  const fs::path number =
      is_dense ? here.filename() : workspace_.model_path.filename();
  std::stable_partition(
      models.begin(), models.end(), [&](const fs::path& model) {
        return (is_dense ? model : model.parent_path()).filename() == number;
      });
  return models;
}

void MaskCameras::ReadOtherCameras() const {
  for (const fs::path& path : OtherModels()) {
    SparseModel model;
    try {
      model = ReadSparseModel(path);
    } catch (const InputError&) {
      if (!original_path_.empty()) {
        throw;
      }
      continue;  // a neighbour that nobody asked for
    }
    for (const SparseImage& image : model.images) {
      others_[image.name].push_back(*model.FindCamera(image.camera_id));
    }
  }
}

}  // namespace octacut
