// mask_renderer: silhouettes of a mesh as the cameras of a sparse model see it.
#pragma once

#include <memory>

#include "plugin/command.h"

namespace octacut {

std::unique_ptr<Command> MakeMaskRenderer();

}  // namespace octacut
