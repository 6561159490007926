// The steps from photographs without masks to masks, shared by the commands
// that make them.
#pragma once

#include <filesystem>
#include <vector>

#include "colmap_io/images/mask_list.h"
#include "colmap_io/images/workspace.h"
#include "core/base/context.h"
#include "plugin/option_manager.h"

namespace octacut {

struct MaskExtractionOptions {
  std::filesystem::path output_path;  // folder of the masks
  std::filesystem::path given_masks_path;
  std::filesystem::path strokes_path;
  std::filesystem::path network_path;  // ONNX file; empty: none
  bool skip_missing_images = false;
  // Whether what the object stands on is left out: 1 yes, 0 no, -1 if the
  // sparse points have a plane and the photographs show something on it.
  int on_stand = -1;
  std::vector<double> bounding_box;  // empty, or x0,y0,z0,x1,y1,z1
};

// given_masks_path, strokes_path, network_path and on_stand.
void DeclareMaskExtractionOptions(OptionManager& options,
                                  MaskExtractionOptions* extraction);

// Segments the object in all photographs and writes masks (<image name>.png),
// masks.json and the contact sheet to the folder, which is created. Masks there
// that octacut did not make, or that were changed since, are used and stay;
// earlier masks of views that are unsure now are removed. All files appear
// together, after everything has been found. The list has an element for each
// photograph, in the order of the model. Throws InputError.
MaskList ExtractMasks(const Workspace& workspace,
                      const MaskExtractionOptions& options,
                      const Context& context);

}  // namespace octacut
