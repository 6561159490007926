// mask_extractor: silhouettes of the object in all photographs.
#pragma once

#include <memory>

#include "plugin/command.h"

namespace octacut {

std::unique_ptr<Command> MakeMaskExtractor();

}  // namespace octacut
