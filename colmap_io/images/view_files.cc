#include "colmap_io/images/view_files.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <system_error>

#include "colmap_io/images/mask_file.h"
#include "colmap_io/images/mask_list.h"
#include "colmap_io/images/missing_files.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMinViews = 3;

bool IsUnsure(const std::optional<MaskList>& list, const std::string& image) {
  const ListedMask* const listed = list ? list->Find(image) : nullptr;
  return listed != nullptr && listed->status == MaskStatus::kUnsure;
}

}  // namespace

void RequireEnoughViews(const Workspace& workspace, size_t count) {
  if (count < kMinViews) {
    throw InputError(
        fmt::format("{}: {} usable views of {} images; at least {} are needed",
                    workspace.model_path.string(),
                    count,
                    workspace.model.images.size(),
                    kMinViews));
  }
}

void RequireSizeOfCamera(const fs::path& path,
                         const ImageSize& size,
                         const SparseCamera& camera) {
  if (size != ImageSize{camera.width, camera.height}) {
    throw InputError(fmt::format(
        "{}: the image has {}x{} pixels, but its camera {} has {}x{}",
        path.string(),
        size.width,
        size.height,
        camera.id,
        camera.width,
        camera.height));
  }
}

void RequireSizeOfCamera(const fs::path& path,
                         const cv::Mat& pixels,
                         const SparseCamera& camera) {
  RequireSizeOfCamera(
      path, ImageSize{uint64_t(pixels.cols), uint64_t(pixels.rows)}, camera);
}

FoundViewFiles FindViewFiles(const Workspace& workspace,
                             const ViewFilesOptions& options,
                             const Context& context) {
  std::map<uint32_t, const SparseCamera*> cameras;
  for (const SparseCamera& camera : workspace.model.cameras) {
    cameras[camera.id] = &camera;
  }
  const std::optional<MaskList> list = ReadMaskList(workspace.mask_path);
  FoundViewFiles found;
  size_t num_unsure_masks = 0;
  MissingFiles images{.what = "image"};
  MissingFiles masks{.what = "mask"};
  for (const SparseImage& image : workspace.model.images) {
    const fs::path path = workspace.image_path / image.name;
    std::error_code ignored;
    if (options.need_images && !fs::is_regular_file(path, ignored)) {
      images.Add(path);
      continue;
    }
    const std::optional<fs::path> mask =
        FindMaskFile(workspace.mask_path, image.name, workspace.image_path);
    if (!mask && IsUnsure(list, image.name)) {
      ++num_unsure_masks;
      continue;
    }
    if (!mask) {
      masks.Add(workspace.mask_path / (image.name + ".png"));
      continue;
    }
    found.views.push_back({&image, cameras.at(image.camera_id), *mask});
  }
  const size_t num_images = workspace.model.images.size();
  images.Report(options.skip_missing_images, num_images, context);
  masks.Report(options.skip_missing_masks, num_images, context);
  if (num_unsure_masks > 0) {
    context.Info(fmt::format(
        "{} of {} images are left out: according to {}, mask_extractor found "
        "no reliable mask for them.",
        num_unsure_masks,
        num_images,
        (workspace.mask_path / kMaskListName).string()));
  }
  found.num_missing_images = images.count;
  found.num_missing_masks = masks.count;
  RequireEnoughViews(workspace, found.views.size());
  for (const ViewFiles& view : found.views) {
    if (options.need_images) {
      const fs::path path = workspace.image_path / view.image->name;
      std::ifstream stream(path, std::ios::binary);
      if (const std::optional<ImageSize> size = ReadImageSize(stream)) {
        RequireSizeOfCamera(path, *size, *view.camera);
      }
    }
  }
  return found;
}

}  // namespace octacut
