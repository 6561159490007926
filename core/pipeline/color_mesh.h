// Colours of the mesh's vertices, from the photographs.
#pragma once

#include "core/base/context.h"
#include "core/grid/labeled_voxels.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/surface_mesh.h"
#include "core/scene/scene.h"
#include "core/views/view_set.h"
#include "core/visibility/visibility.h"

namespace octacut {

// `mesh`, which has normals, with vertex colours: the mean over the views that
// see the vertex, weighted as Visibility does. Vertices that no view sees have
// the colours around them. `surface` is the labelling that the mesh came from.
SurfaceMesh ColoredMesh(const IndexedMesh& mesh,
                        const ViewSet& views,
                        const LabeledVoxels& surface,
                        const BoundingCube& cube,
                        const VisibilityOptions& options,
                        const Context& context);

}  // namespace octacut
