#include "plugin/quality.h"

#include <fmt/format.h>

#include <algorithm>

namespace octacut {
namespace {

struct Preset {
  std::string_view name;
  int target_level;
  bool refine;
};

Preset PresetOf(Quality quality) {
  switch (quality) {
    case Quality::kLow:
      return {"low", 8, false};
    case Quality::kMedium:
      return {"medium", 9, false};
    case Quality::kHigh:
      return {"high", 9, true};
    case Quality::kExtreme:
      return {"extreme", 10, true};
  }
  throw InvariantError("unknown quality");
}

}  // namespace

void QualityOption::Declare(OptionManager& options) {
  options.AddEnum("quality",
                  &quality_,
                  {{"low", Quality::kLow},
                   {"medium", Quality::kMedium},
                   {"high", Quality::kHigh},
                   {"extreme", Quality::kExtreme}},
                  "Preset. Without refinement: low (256^3 voxels), medium "
                  "(512^3). With refinement: high (512^3), extreme (1024^3).");
}

std::string QualityOption::Apply(const OptionManager& options,
                                 ReconstructionOptions* meshing) const {
  const Preset preset = PresetOf(quality_);
  const bool level_is_given = options.IsSet("OctahedralMeshing.target_level");
  const bool refine_is_given = options.IsSet("OctahedralMeshing.refine");
  if (!level_is_given) {
    meshing->target_level = preset.target_level;
  }
  if (!refine_is_given) {
    meshing->refine = preset.refine;
  }
  std::string given;
  if (level_is_given) {
    given += " --OctahedralMeshing.target_level";
  }
  if (refine_is_given) {
    given += given.empty() ? "" : " and";
    given += " --OctahedralMeshing.refine";
  }
  return fmt::format("Quality {}{}: {}^3 voxels (level {}), {} refinement.",
                     preset.name,
                     given.empty() ? "" : " with the given" + given,
                     1 << std::clamp(meshing->target_level, 0, 30),
                     meshing->target_level,
                     meshing->refine ? "with" : "without");
}

}  // namespace octacut
