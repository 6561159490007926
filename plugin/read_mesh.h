// Reading a mesh for a command.
#pragma once

#include <filesystem>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// As ReadMesh does; logs what was changed or left out on the way.
IndexedMesh ReadMeshAndLog(const std::filesystem::path& path,
                           const Context& context);

}  // namespace octacut
