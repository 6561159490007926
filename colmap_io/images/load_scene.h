// From a COLMAP workspace to a Scene: the one way in.
#pragma once

#include <cstddef>
#include <filesystem>

#include "colmap_io/images/bad_views.h"
#include "colmap_io/images/for_each_file.h"
#include "colmap_io/images/mask_geometry.h"
#include "colmap_io/images/view_window.h"
#include "colmap_io/images/workspace.h"
#include "core/base/context.h"
#include "core/scene/region.h"
#include "core/scene/scene.h"

namespace octacut {

struct LoadSceneOptions {
  WorkspaceOptions workspace;
  MaskGeometry mask_geometry = MaskGeometry::kAuto;
  // Model of the original photographs, for a dense folder whose masks are in
  // their geometry; empty: looked for in ../sparse and ../../sparse.
  std::filesystem::path original_path;
  // Go on without the images that have no file or no mask, or a mask that is
  // all background or all object; warnings count them.
  bool skip_missing_images = false;
  bool skip_missing_masks = false;
  // False: views that contradict the others are left out.
  bool keep_all_views = false;
  // Bites out of masks (FindBites) are filled, before the region is found,
  // which they would cut, unless it is given.
  bool fill_bites = false;
  // False: the views get masks only, and images need not exist.
  bool load_images = true;
  RegionOptions region;
  WindowOptions window;
  // Bytes that decoded files may take at a time while loading.
  size_t decode_budget = kDecodeBudget;

  void Check() const;
};

struct LoadSceneSummary {
  std::filesystem::path image_path;
  std::filesystem::path model_path;
  std::filesystem::path mask_path;
  size_t num_images = 0;                 // registered, of those listed
  size_t num_views = 0;                  // of the scene
  size_t num_missing_images = 0;         // skipped
  size_t num_missing_masks = 0;          // skipped
  size_t num_masks_without_outline = 0;  // skipped: all of one kind
  BadViewSummary bad_views;              // contradict the others
  size_t num_filled_bites = 0;
  size_t num_views_elsewhere = 0;  // left out: they do not show the region
  size_t num_points = 0;           // of the scene
  size_t scene_bytes = 0;          // of images and masks held
  double mask_seconds = 0;
  double region_seconds = 0;
  double image_seconds = 0;
};

struct LoadedScene {
  Scene scene;  // views in the order of the model's images
  Region region;
  LoadSceneSummary summary;
};

// Reads model, masks and images of the workspace, finds the region, and holds
// every view undistorted, cropped to the region and at the resolution that
// voxels of `target_level` need.
//
// Two passes keep memory small: the first reads masks only and keeps them
// reduced; the second, when the region is known, reads one photograph a thread.
// context.Info tells what is used and how much memory it takes.
//
// Throws InputError for whatever section of the workspace cannot be used: an
// image or mask that is missing, damaged, of another size than its camera, a
// mask without object or without background, too many views that contradict
// the others, fewer than 3 usable views.
LoadedScene LoadScene(const std::filesystem::path& workspace_path,
                      const LoadSceneOptions& options,
                      int target_level,
                      const Context& context);

}  // namespace octacut
