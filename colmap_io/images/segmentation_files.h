// From a workspace without masks to what core/segment works on.
#pragma once

#include <cstddef>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "colmap_io/images/workspace.h"
#include "core/base/context.h"
#include "core/segment/segment_object.h"

namespace octacut {

struct SegmentationFilesOptions {
  // Folder of finished masks for some views; empty: none. Must exist.
  std::filesystem::path given_masks_path;
  // Folder of pictures for some views: 0 background, 255 object, nothing said
  // between; empty: none. Must exist. Of masks of all that turns (mask_list.h),
  // only the background counts.
  std::filesystem::path strokes_path;
  // Folder that masks go to. Those in it that octacut did not make, or that
  // were changed since, are given masks, too.
  std::filesystem::path output_path;
  bool skip_missing_images = false;
  // Longest side of the views that are made, pixels.
  int longest_side = 320;
};

// A photograph that takes part; points into the workspace.
struct SegmentationFile {
  const SparseImage* image = nullptr;
  const SparseCamera* camera = nullptr;
  std::filesystem::path photograph;
  std::filesystem::path given_mask;  // empty: to be found
  std::filesystem::path strokes;     // empty: none
  bool strokes_are_turntable_mask = false;
};

struct SegmentationFiles {
  std::vector<SegmentationFile> files;  // in the order of the model
  SegmentationInput input;              // a view for each file, without box
};

// Finds the files and reads all photographs, reduced. Throws InputError naming
// the file that is missing, damaged or of another size than its camera, for
// fewer than 3 photographs, and for a folder of helps that fits no photograph.
SegmentationFiles ReadSegmentationFiles(const Workspace& workspace,
                                        const SegmentationFilesOptions& options,
                                        const Context& context);

// The strokes of `file`, which has some that are no turntable's mask, as labels
// (core/segment/labels.h, CV_8UC1) of the photograph's size. Throws InputError
// where they cannot be read or are of another size.
cv::Mat ReadStrokes(const SegmentationFile& file);

// For loops over the photographs at full size with `bytes_per_pixel` each.
size_t BytesOfLargest(const std::vector<SegmentationFile>& files,
                      size_t bytes_per_pixel);

}  // namespace octacut
