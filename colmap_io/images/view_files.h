// Which images of a model have the files that a view needs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "colmap_io/images/image_header.h"
#include "colmap_io/images/workspace.h"
#include "core/base/context.h"

namespace octacut {

struct ViewFilesOptions {
  bool need_images = true;  // false: masks alone will do
  bool skip_missing_images = false;
  bool skip_missing_masks = false;
};

// An image that can become a view; points into the workspace.
struct ViewFiles {
  const SparseImage* image = nullptr;
  const SparseCamera* camera = nullptr;
  std::filesystem::path mask_file;
};

struct FoundViewFiles {
  std::vector<ViewFiles> views;  // in the order of the model
  size_t num_missing_images = 0;
  size_t num_missing_masks = 0;  // of the images that are there
};

// Finds image and mask of every registered image. Images that octacut was
// unsure of when it made the masks (mask_list.h) are left out. What else is
// missing is an InputError, or, when it may be skipped, one context.Warn that
// counts it. Throws InputError too when fewer than 3 views are left, or when
// the header of an image gives another size than its camera.
FoundViewFiles FindViewFiles(const Workspace& workspace,
                             const ViewFilesOptions& options,
                             const Context& context);

// Throws InputError unless `count` views are enough: at least 3.
void RequireEnoughViews(const Workspace& workspace, size_t count);

// Throws InputError unless the image at `path`, of that size, fits the camera.
void RequireSizeOfCamera(const std::filesystem::path& path,
                         const ImageSize& size,
                         const SparseCamera& camera);
void RequireSizeOfCamera(const std::filesystem::path& path,
                         const cv::Mat& pixels,
                         const SparseCamera& camera);

}  // namespace octacut
