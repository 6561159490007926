// The picture beside a report: the shaded mesh beside a photograph.
#pragma once

#include <filesystem>

#include "colmap_io/files/atomic_files.h"
#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/scene/scene.h"

namespace octacut {

// Writes a PNG, when `files` are committed: the photograph of the view that
// shows most of the object, the mesh shaded from the same camera, and the mesh
// with its colours.
void WriteRunPicture(const std::filesystem::path& path,
                     const Scene& scene,
                     const IndexedMesh& mesh,
                     const Context& context,
                     AtomicFiles* files);

}  // namespace octacut
