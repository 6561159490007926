// From the labelling of the last level to the mesh that the user gets.
#pragma once

#include "core/base/context.h"
#include "core/grid/labeled_voxels.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/surface_mesh.h"
#include "core/pipeline/options.h"
#include "core/pipeline/summary.h"
#include "core/scene/scene.h"
#include "core/views/view_set.h"

namespace octacut {

// The labelling's surface with vertices positioned but not smoothed.
IndexedMesh PositionedMesh(const LabeledVoxels& surface,
                           const BoundingCube& cube,
                           const Context& context);

struct FinishedMesh {
  IndexedMesh mesh;
  IndexedMesh removed;  // components that were too small, before smoothing
};

// Extraction, placement and smoothing; components smaller than the
// options say are removed, and handles as `min_handle` says. No triangles
// intersect, once coordinates are rounded to the floats of files either. With
// normals, without colours. Throws InputError when there is no surface. `views`
// say how large pixels are, and what silhouettes show.
FinishedMesh FinalMesh(const ViewSet& views,
                       const LabeledVoxels& surface,
                       const BoundingCube& cube,
                       const ReconstructionOptions& options,
                       const Context& context,
                       ReconstructionSummary* summary);

// `mesh`, which has normals, with vertex colours: the mean over the views that
// see the vertex, weighted as Visibility does; grey where none does. `surface`
// is the labelling that the mesh came from.
SurfaceMesh ColoredMesh(const IndexedMesh& mesh,
                        const ViewSet& views,
                        const LabeledVoxels& surface,
                        const BoundingCube& cube,
                        const VisibilityOptions& options,
                        const Context& context);

}  // namespace octacut
