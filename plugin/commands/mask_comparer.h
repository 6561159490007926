// mask_comparer: masks measured against reference masks.
#pragma once

#include <memory>

#include "plugin/command.h"

namespace octacut {

std::unique_ptr<Command> MakeMaskComparer();

}  // namespace octacut
