// Reading a mesh for a command.
#pragma once

#include <filesystem>

#include "colmap_io/mesh/mesh_io.h"
#include "core/base/context.h"

namespace octacut {

// As ReadMesh does; logs what was changed or left out on the way.
MeshFile ReadMeshAndLog(const std::filesystem::path& path,
                        const Context& context);

}  // namespace octacut
