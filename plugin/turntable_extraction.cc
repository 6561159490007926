#include "plugin/turntable_extraction.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "colmap_io/files/lower_extension.h"
#include "colmap_io/files/read_file.h"
#include "colmap_io/files/require_folder.h"
#include "colmap_io/images/for_each_file.h"
#include "colmap_io/images/image_file.h"
#include "colmap_io/images/mask_file.h"
#include "colmap_io/images/mask_folder.h"
#include "core/base/error.h"
#include "core/scene/scene.h"
#include "core/segment/refine_border.h"
#include "core/segment/turntable.h"
#include "plugin/contact_sheet.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Longest side of the photographs as they are compared, pixels; the borders of
// larger ones are refined at full size.
constexpr int kComparedSide = 1024;
constexpr double kBorderReach = 2;  // of these pixels
constexpr size_t kMinPhotographs = 3;

bool IsPhotograph(const fs::path& path) {
  const std::string extension = LowerExtension(path);
  constexpr std::array<std::string_view, 7> kExtensions = {
      ".jpg", ".jpeg", ".png", ".tif", ".tiff", ".bmp", ".webp"};
  return std::find(kExtensions.begin(), kExtensions.end(), extension) !=
         kExtensions.end();
}

std::vector<fs::path> PhotographsIn(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file() && IsPhotograph(entry.path())) {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

bool IsSameFolder(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

// Folders with photographs of the object: `image_path` and those below it, but
// for those of the other paths.
std::vector<fs::path> FoldersOf(const TurntableExtractionOptions& options) {
  std::vector<fs::path> folders = {options.image_path};
  std::error_code error;
  for (auto entry = fs::recursive_directory_iterator(options.image_path, error);
       entry != fs::recursive_directory_iterator();
       entry.increment(error)) {
    if (!entry->is_directory()) {
      continue;
    }
    if (IsSameFolder(entry->path(), options.output_path) ||
        IsSameFolder(entry->path(), options.background_path)) {
      entry.disable_recursion_pending();
    } else {
      folders.push_back(entry->path());
    }
  }
  std::sort(folders.begin(), folders.end());
  folders.erase(std::remove_if(folders.begin(),
                               folders.end(),
                               [](const fs::path& path) {
                                 return PhotographsIn(path).empty();
                               }),
                folders.end());
  return folders;
}

cv::Mat Reduced(const cv::Mat& image) {
  const double factor =
      double(kComparedSide) / std::max(image.cols, image.rows);
  if (factor >= 1) {
    return image;
  }
  cv::Mat small;
  cv::resize(image, small, {}, factor, factor, cv::INTER_AREA);
  return small;
}

// The photographs of one camera.
class TurntableFolder {
 public:
  TurntableFolder(const TurntableExtractionOptions& options,
                  const fs::path& folder,
                  const Context& context)
      : options_(options), context_(context), paths_(PhotographsIn(folder)) {
    if (paths_.size() < kMinPhotographs) {
      throw InputError(
          fmt::format("image_path {}: {} photographs; at least {} are needed",
                      folder.string(),
                      paths_.size(),
                      kMinPhotographs));
    }
    if (!options.background_path.empty()) {
      const fs::path relative = folder.lexically_relative(options.image_path);
      const fs::path same = options.background_path / relative;
      std::error_code ignored;
      empty_paths_ = PhotographsIn(
          fs::is_directory(same, ignored) ? same : options.background_path);
      if (empty_paths_.empty()) {
        throw InputError(fmt::format("background_path {}: no photographs in it",
                                     options.background_path.string()));
      }
    }
  }

  void Extract(MaskList* list,
               std::vector<std::vector<uchar>>* pngs,
               std::vector<UnsegmentedView>* views,
               std::vector<cv::Mat>* masks);

 private:
  std::vector<cv::Mat> Read(const std::vector<fs::path>& paths);
  // A mask file, as large as the photographs are compared.
  cv::Mat ReadGivenMask(const fs::path& path, const cv::Size& compared) const;

  const TurntableExtractionOptions& options_;
  const Context& context_;
  std::vector<fs::path> paths_;
  std::vector<fs::path> empty_paths_;
  cv::Size size_;  // of the photographs
};

std::vector<cv::Mat> TurntableFolder::Read(const std::vector<fs::path>& paths) {
  if (size_.empty()) {
    size_ = ReadPhotograph(paths.front()).size();
  }
  std::vector<cv::Mat> images(paths.size());
  ForEachFile(
      {.count = paths.size(), .bytes_per_file = 8 * size_t(size_.area())},
      "reading photographs",
      context_,
      [&](size_t i) {
        const cv::Mat image = ReadPhotograph(paths[i]);
        if (image.size() != size_) {
          throw InputError(fmt::format(
              "{}: the image has {}x{} pixels, but {} has {}x{}; those "
              "of a turntable's camera are of one size",
              paths[i].string(),
              image.cols,
              image.rows,
              paths_.front().string(),
              size_.width,
              size_.height));
        }
        images[i] = Reduced(image);
      });
  return images;
}

cv::Mat TurntableFolder::ReadGivenMask(const fs::path& path,
                                       const cv::Size& compared) const {
  cv::Mat mask = ReadMask(path);
  if (mask.size() != size_) {
    throw InputError(
        fmt::format("{}: the mask has {}x{} pixels, but its photograph {}x{}",
                    path.string(),
                    mask.cols,
                    mask.rows,
                    size_.width,
                    size_.height));
  }
  cv::resize(mask, mask, compared, 0, 0, cv::INTER_AREA);
  return mask >= kObjectThreshold;
}

void TurntableFolder::Extract(MaskList* list,
                              std::vector<std::vector<uchar>>* pngs,
                              std::vector<UnsegmentedView>* views,
                              std::vector<cv::Mat>* masks) {
  TurntableInput input;
  input.images = Read(paths_);
  input.empty_set =
      empty_paths_.empty() ? std::vector<cv::Mat>() : Read(empty_paths_);
  const std::vector<TurntableView> found = SegmentTurntable(input, context_);
  std::vector<std::vector<uchar>> encoded(paths_.size());
  const bool is_reduced = input.images.front().size() != size_;
  ForEachFile(
      {.count = paths_.size(),
       .bytes_per_file = kRefineBorderBytesPerPixel * size_t(size_.area()),
       .byte_budget = kRefineBorderBudget},
      "refining borders",
      context_,
      [&](size_t i) {
        cv::Mat mask = found[i].mask;
        if (!found[i].doubt.empty()) {
          return;
        }
        if (is_reduced) {
          const double scale = double(size_.width) / mask.cols;
          cv::resize(mask, mask, size_, 0, 0, cv::INTER_LINEAR);
          mask = RefineBorder(ReadPhotograph(paths_[i]),
                              mask >= kObjectThreshold,
                              kBorderReach * scale);
        }
        encoded[i] = EncodeMask(mask);
      });
  const std::optional<MaskList> before = ReadMaskList(options_.output_path);
  for (size_t i = 0; i < paths_.size(); ++i) {
    ListedMask& listed = list->views.emplace_back();
    listed.image = paths_[i].lexically_relative(options_.image_path).string();
    listed.confidence = found[i].confidence;
    const std::optional<fs::path> there =
        FindMaskFile(options_.output_path, listed.image, options_.image_path);
    if (there && !IsExtractedMask(before, listed.image, *there)) {
      encoded[i].clear();
      listed.status = MaskStatus::kGiven;
      listed.confidence = 1;
      listed.mask = there->lexically_relative(options_.output_path).string();
      listed.hash = HashOfBytes(ReadFile(*there));
    } else if (!found[i].doubt.empty()) {
      listed.status = MaskStatus::kUnsure;
      listed.doubt = found[i].doubt;
    }
    UnsegmentedView& view = views->emplace_back();
    view.image = input.images[i];
    masks->push_back(listed.status == MaskStatus::kGiven
                         ? ReadGivenMask(*there, view.image.size())
                         : found[i].mask);
    pngs->push_back(std::move(encoded[i]));
  }
}

}  // namespace

MaskList ExtractTurntableMasks(const TurntableExtractionOptions& options,
                               const Context& context) {
  RequireFolder(options.image_path, "image_path");
  if (!options.background_path.empty()) {
    RequireFolder(options.background_path, "background_path");
  }
  RequireFolderForMasks(options.output_path, options.image_path);
  MaskList list;
  list.is_of_turntable = true;
  std::vector<std::vector<uchar>> pngs;
  std::vector<UnsegmentedView> views;
  std::vector<cv::Mat> masks;
  const std::vector<fs::path> folders = FoldersOf(options);
  if (folders.empty()) {
    throw InputError(fmt::format("image_path {}: no photographs in it",
                                 options.image_path.string()));
  }
  for (const fs::path& folder : folders) {
    TurntableFolder(options, folder, context)
        .Extract(&list, &pngs, &views, &masks);
  }
  WriteMaskFolder(
      options.output_path, list, pngs, DrawContactSheet(views, masks, list));
  return list;
}

}  // namespace octacut
