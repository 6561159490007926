// In which geometry a mask is: that of the original photographs or that of the
// undistorted images.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "colmap_io/images/image_header.h"
#include "colmap_io/images/workspace.h"
#include "colmap_io/model/camera_models.h"

namespace octacut {

enum class MaskGeometry {
  kAuto,         // found from the size
  kOriginal,     // of the photographs as they were taken
  kUndistorted,  // of image_undistorter's output
};

// Finds the camera that the mask of an image was made with. Thread safe.
//
// The size decides: the size of the image's camera means the image's own
// geometry. Otherwise, in a project the mask may be that of an undistorted
// image (of a dense folder in W/dense, W/dense/<i>, or as image_undistorter
// would make it); in a dense folder it may be that of the original photograph,
// for which the original model is needed: `original_path`, or a model in
// ../sparse or ../../sparse. Where several models hold the image, that with the
// workspace's number comes first (dense/1 is made of sparse/1), then the others
// in the order of their names; the first camera of the mask's size counts.
class MaskCameras {
 public:
  // The workspace must outlive this. `original_path` may be empty; throws
  // InputError when it holds no model, or the workspace is no dense folder.
  MaskCameras(const Workspace& workspace,
              MaskGeometry geometry,
              const std::filesystem::path& original_path);

  // `camera` is that of the image; `mask_name` is for messages. Throws
  // InputError when the size fits no camera.
  SparseCamera Find(const SparseImage& image,
                    const SparseCamera& camera,
                    const ImageSize& mask_size,
                    const std::string& mask_name) const;

 private:
  using CamerasByName = std::map<std::string, std::vector<SparseCamera>>;

  // Cameras of the same photographs in the other geometry.
  const CamerasByName& OtherCameras() const;
  void ReadOtherCameras() const;
  std::vector<std::filesystem::path> OtherModels() const;
  std::vector<SparseCamera> OtherCameras(const SparseImage& image,
                                         const SparseCamera& camera) const;

  const Workspace& workspace_;
  MaskGeometry geometry_;
  std::filesystem::path original_path_;
  mutable std::once_flag once_;
  mutable CamerasByName others_;
};

}  // namespace octacut
