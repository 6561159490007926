// Removes crumbs: small components of a closed mesh.
#pragma once

#include <cstddef>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct KeptComponents {
  IndexedMesh mesh;
  // Those that were removed and are no cavities.
  IndexedMesh removed;
  size_t num_removed = 0;  // with cavities
};

// Keeps the components (connected through vertices) whose volume is at least
// `min_fraction` (in [0, 1], else OptionError) of the largest one's. 1 keeps
// the largest alone, 0 everything. Normals and colours of `mesh` must be empty.
//
// A component of negative volume bounds a cavity of another one. It is judged
// by its absolute volume, so small cavities are filled. The cavities of a
// removed component are removed as well, because they are smaller. The order of
// vertices and triangles stays.
KeptComponents KeepLargestComponents(IndexedMesh mesh, double min_fraction);

}  // namespace octacut
