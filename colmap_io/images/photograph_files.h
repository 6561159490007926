// The photographs of a workspace at full resolution, read when they are needed:
// what texturing works on.
#pragma once

#include <cstddef>
#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "colmap_io/images/mask_geometry.h"
#include "colmap_io/images/workspace.h"
#include "core/base/context.h"
#include "core/texture/photographs.h"

namespace octacut {

struct PhotographOptions {
  WorkspaceOptions workspace;
  MaskGeometry mask_geometry = MaskGeometry::kAuto;
  std::filesystem::path original_path;  // as LoadSceneOptions has it
  bool skip_missing_images = false;
  // What is to be seen: views are cropped to it, and those that do not show it
  // are left out.
  Eigen::AlignedBox3d box;
  // If not empty, only the images of these names.
  std::vector<std::string> names;
  // Bytes that photographs may take while they are worked on, and that those
  // which are kept for the next time may take.
  size_t decode_budget = size_t{3} << 29;
  size_t cache_budget = size_t{1} << 30;
};

struct PhotographSummary {
  std::filesystem::path image_path;
  std::filesystem::path model_path;
  std::filesystem::path mask_path;  // empty: there are no masks
  size_t num_images = 0;            // registered, of those listed
  size_t num_missing = 0;           // skipped
  size_t num_without_mask = 0;      // used as a whole
  size_t num_elsewhere = 0;         // do not show the box
};

struct PhotographFiles {
  Photographs photographs;  // in the order of the model
  PhotographSummary summary;
};

// Photographs are undistorted, cropped and masked in memory, at their own
// resolution. Masks are used where there are some; where there is a folder of
// masks, photographs without one are counted by a warning. Throws InputError
// for a model without images, for images that are missing or do not fit their
// cameras; `load` of the result throws it for files that cannot be read.
PhotographFiles OpenPhotographs(const std::filesystem::path& workspace_path,
                                const PhotographOptions& options,
                                const Context& context);

}  // namespace octacut
