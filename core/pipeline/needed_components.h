// Small components of a mesh without which the silhouettes are not covered.
#pragma once

#include <cstddef>

#include "core/base/context.h"
#include "core/mesh/keep_components.h"
#include "core/scene/scene.h"
#include "core/views/view_set.h"

namespace octacut {

// Gives those components of kept->removed back to kept->mesh, all in world
// coordinates, that alone cover pixels which are surely object: a thousandth of
// the object and more in at least two views. Noise of depths and masks makes
// smaller ones, and one view alone is no witness. Of components that cover the
// same pixels the one with the most triangles comes back. Returns their number;
// normals and colours of the meshes must be empty.
size_t RestoreNeededComponents(const ViewSet& views,
                               const BoundingCube& cube,
                               const Context& context,
                               KeptComponents* kept);

}  // namespace octacut
