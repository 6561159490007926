// octacut mesh_texturer: texture a mesh from the photographs of a workspace.
#pragma once

#include <memory>

#include "plugin/command.h"

namespace octacut {

std::unique_ptr<Command> MakeMeshTexturer();

}  // namespace octacut
