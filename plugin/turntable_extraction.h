// The steps from photographs of a turntable, without any cameras, to masks.
#pragma once

#include <filesystem>

#include "core/base/context.h"
#include "plugin/mask_extraction.h"

namespace octacut {

struct TurntableExtractionOptions {
  std::filesystem::path image_path;
  std::filesystem::path output_path;      // folder of the masks
  std::filesystem::path background_path;  // empty: none
};

// Masks of what turns in the photographs in `image_path` and below it, and
// masks.json and contact sheet as ExtractMasks writes them. The photographs of
// each folder are from one camera that did not move; those of the empty set are
// in a folder of the same name in `background_path`, or in that itself. Masks
// in the output folder that octacut did not make stay. Throws InputError.
MaskList ExtractTurntableMasks(const TurntableExtractionOptions& options,
                               const Context& context);

}  // namespace octacut
