// --quality, as COLMAP's automatic_reconstructor has it: one word for the
// resolution of a reconstruction and for what belongs to it.
#pragma once

#include <string>

#include "core/pipeline/options.h"
#include "plugin/option_manager.h"

namespace octacut {

enum class Quality { kLow, kMedium, kHigh, kExtreme };

class QualityOption {
 public:
  void Declare(OptionManager& options);

  // Sets what belongs to the quality, except what `options` set themselves.
  // Returns a sentence for the log that says what was chosen.
  std::string Apply(const OptionManager& options,
                    ReconstructionOptions* meshing) const;

 private:
  Quality quality_ = Quality::kHigh;
};

}  // namespace octacut
