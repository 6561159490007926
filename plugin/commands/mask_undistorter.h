// mask_undistorter: masks of original photographs in the geometry of the images
// that COLMAP's image_undistorter makes.
#pragma once

#include <memory>

#include "plugin/command.h"

namespace octacut {

std::unique_ptr<Command> MakeMaskUndistorter();

}  // namespace octacut
