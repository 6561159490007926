#pragma once

#include <memory>

#include "plugin/command.h"

namespace octacut {

std::unique_ptr<Command> MakeDepthMapRenderer();

}  // namespace octacut
