// A mesh file that has to be closed.
#pragma once

#include <filesystem>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// With its positions rounded to floats, which is what files hold. Throws
// InputError that names what the mesh lacks unless it is a closed 2-manifold,
// oriented outward.
IndexedMesh ReadClosedMesh(const std::filesystem::path& path,
                           const Context& context);

// Throws OptionError "<option> = ...: must not be <what>" where `path` leads to
// the same file as `other`.
void CheckIsAnotherFile(const char* option,
                        const std::filesystem::path& path,
                        const std::filesystem::path& other,
                        const char* what);

}  // namespace octacut
