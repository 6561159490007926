#include "colmap_io/images/segmentation_files.h"

#include <fmt/format.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <system_error>

#include "colmap_io/files/require_folder.h"
#include "colmap_io/images/for_each_file.h"
#include "colmap_io/images/image_file.h"
#include "colmap_io/images/mask_file.h"
#include "colmap_io/images/mask_list.h"
#include "colmap_io/images/missing_files.h"
#include "colmap_io/images/most_pixels.h"
#include "colmap_io/images/reduced_view.h"
#include "colmap_io/images/view_files.h"
#include "core/base/error.h"
#include "core/segment/labels.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Decoded photograph, help and file.
constexpr size_t kDecodedBytes = 8;
// Part of a reduced pixel that a stroke must cover to count.
constexpr int kStrokeCoverage = 64;
// Reduced pixels by which the border of a turntable's mask may be off.
constexpr int kNearTurning = 1;

// That masks or strokes of another set are not given in silence.
void RequireUse(const fs::path& path, std::string_view option, size_t count) {
  if (!path.empty() && count == 0) {
    throw InputError(
        fmt::format("{} {}: no file in the folder is named after an image of "
                    "the model",
                    option,
                    path.string()));
  }
}

fs::path FindIn(const fs::path& folder,
                const SparseImage& image,
                const Workspace& workspace) {
  if (folder.empty()) {
    return {};
  }
  return FindMaskFile(folder, image.name, workspace.image_path)
      .value_or(fs::path());
}

std::vector<SegmentationFile> FindFiles(const Workspace& workspace,
                                        const SegmentationFilesOptions& options,
                                        const Context& context) {
  if (!options.given_masks_path.empty()) {
    RequireFolder(options.given_masks_path, "given_masks_path");
  }
  if (!options.strokes_path.empty()) {
    RequireFolder(options.strokes_path, "strokes_path");
  }
  const std::optional<MaskList> list = ReadMaskList(options.output_path);
  const std::optional<MaskList> strokes =
      options.strokes_path.empty() ? std::nullopt
                                   : ReadMaskList(options.strokes_path);
  std::vector<SegmentationFile> files;
  MissingFiles missing{.what = "image"};
  size_t num_given = 0;
  size_t num_strokes = 0;
  for (const SparseImage& image : workspace.model.images) {
    SegmentationFile file;
    file.image = &image;
    file.camera = workspace.model.FindCamera(image.camera_id);
    file.photograph = workspace.image_path / image.name;
    std::error_code ignored;
    if (!fs::is_regular_file(file.photograph, ignored)) {
      missing.Add(file.photograph);
      continue;
    }
    file.given_mask = FindIn(options.given_masks_path, image, workspace);
    num_given += file.given_mask.empty() ? 0 : 1;
    const fs::path there = FindIn(options.output_path, image, workspace);
    if (!there.empty() && !IsExtractedMask(list, image.name, there)) {
      if (file.given_mask.empty()) {
        file.given_mask = there;
      } else {
        RequireSameMask(file.given_mask, there, image.name);
      }
    }
    file.strokes = FindIn(options.strokes_path, image, workspace);
    file.strokes_are_turntable_mask = strokes && strokes->is_of_turntable;
    num_strokes += file.strokes.empty() ? 0 : 1;
    files.push_back(std::move(file));
  }
  missing.Report(
      options.skip_missing_images, workspace.model.images.size(), context);
  RequireUse(options.given_masks_path, "given_masks_path", num_given);
  RequireUse(options.strokes_path, "strokes_path", num_strokes);
  RequireEnoughViews(workspace, files.size());
  return files;
}

// What is clearly outside of a mask of all that turns is background.
cv::Mat OutsideOf(const cv::Mat& turning,
                  const SparseCamera& camera,
                  const PinholeCamera& reduced) {
  cv::Mat near;
  cv::dilate(ReduceView(turning, camera, reduced) > 0,
             near,
             cv::Mat::ones(2 * kNearTurning + 1, 2 * kNearTurning + 1, CV_8U));
  cv::Mat labels(reduced.height, reduced.width, CV_8U, cv::Scalar(kNoLabel));
  labels.setTo(kSurroundingsLabel, near == 0);
  return labels;
}

// CV_8UC1, as the file has it.
cv::Mat ReadStrokesFile(const SegmentationFile& file) {
  cv::Mat strokes = ReadGrey(file.strokes);
  RequireSizeOfCamera(file.strokes, strokes, *file.camera);
  return strokes;
}

cv::Mat ReducedStrokes(const SegmentationFile& file,
                       const PinholeCamera& reduced) {
  if (file.strokes_are_turntable_mask) {
    return OutsideOf(ReadStrokesFile(file), *file.camera, reduced);
  }
  const cv::Mat strokes = ReadStrokes(file);
  cv::Mat labels(reduced.height, reduced.width, CV_8U, cv::Scalar(kNoLabel));
  for (const uint8_t label : {kSurroundingsLabel, kObjectLabel}) {
    labels.setTo(
        label,
        ReduceView(strokes == label, *file.camera, reduced) > kStrokeCoverage);
  }
  return labels;
}

UnsegmentedView ReadView(const SegmentationFile& file, int longest_side) {
  UnsegmentedView view;
  view.pose = {ReducedCamera(*file.camera, longest_side),
               file.image->CamFromWorld()};
  const cv::Mat photograph = ReadPhotograph(file.photograph);
  RequireSizeOfCamera(file.photograph, photograph, *file.camera);
  view.image = ReduceView(photograph, *file.camera, view.pose.camera);
  if (!file.given_mask.empty()) {
    const cv::Mat mask = ReadMask(file.given_mask);
    RequireSizeOfCamera(file.given_mask, mask, *file.camera);
    const cv::Mat reduced = ReduceView(mask, *file.camera, view.pose.camera);
    view.labels.create(reduced.size(), CV_8U);
    view.labels.setTo(kSurroundingsLabel);
    view.labels.setTo(kObjectLabel, reduced >= kObjectThreshold);
  } else if (!file.strokes.empty()) {
    view.labels = ReducedStrokes(file, view.pose.camera);
    view.is_turntable = file.strokes_are_turntable_mask;
  }
  return view;
}

}  // namespace

cv::Mat ReadStrokes(const SegmentationFile& file) {
  const cv::Mat strokes = ReadStrokesFile(file);
  cv::Mat labels(strokes.size(), CV_8U, cv::Scalar(kNoLabel));
  // A JPEG file does not keep the values to the last bit.
  constexpr int kMiddle = kNoLabel / 2;
  labels.setTo(kSurroundingsLabel, strokes < kMiddle);
  labels.setTo(kObjectLabel, strokes > kNoLabel + kMiddle);
  return labels;
}

size_t BytesOfLargest(const std::vector<SegmentationFile>& files,
                      size_t bytes_per_pixel) {
  return bytes_per_pixel * MostPixels(files, &SegmentationFile::camera);
}

SegmentationFiles ReadSegmentationFiles(const Workspace& workspace,
                                        const SegmentationFilesOptions& options,
                                        const Context& context) {
  SegmentationFiles result;
  result.files = FindFiles(workspace, options, context);
  result.input.views.resize(result.files.size());
  ForEachFile({.count = result.files.size(),
               .bytes_per_file = BytesOfLargest(result.files, kDecodedBytes)},
              "reading photographs",
              context,
              [&](size_t i) {
                result.input.views[i] =
                    ReadView(result.files[i], options.longest_side);
              });
  return result;
}

}  // namespace octacut
