// A mesh file that has to be closed.
#pragma once

#include <filesystem>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// With its positions rounded to floats, which is what files hold. Throws
// InputError that names what the mesh lacks unless it is a closed 2-manifold,
// oriented outward, and where it is so far from the origin that floats are too
// coarse for it.
IndexedMesh ReadClosedMesh(const std::filesystem::path& path,
                           const Context& context);

}  // namespace octacut
