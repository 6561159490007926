// From the labelling of the last level to the mesh that the user gets.
#pragma once

#include <cstddef>

#include "core/base/context.h"
#include "core/extract/extract_surface.h"
#include "core/grid/labeled_voxels.h"
#include "core/handles/remove_handles.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/smooth.h"
#include "core/scene/scene.h"
#include "core/views/view_set.h"

namespace octacut {

// The labelling's surface with vertices positioned but not smoothed.
IndexedMesh PositionedMesh(const LabeledVoxels& surface,
                           const BoundingCube& cube,
                           const Context& context);

struct FinishOptions {
  SmoothOptions smoothing;
  // Components with less than this share of the largest one's volume are
  // removed, but for those that RestoreNeededComponents keeps, and cavities
  // filled; 0 .. 1.
  double min_component = 0.1;
  // Handles around which a loop no longer than so many voxels goes, or pixels
  // of the views where those are larger, are removed: bridges cut, and tunnels
  // filled of up to twice that. Where no silhouette shows the handle, both
  // limits are four times `min_handle`; where one does, but its border is known
  // to be too large, bridges may be as long as tunnels. 0 (none) .. 64.
  double min_handle = 5;
  void Check() const;
};

struct FinishSummary {
  ExtractSurfaceSummary extraction;
  size_t num_removed_components = 0;
  RemoveHandlesSummary handles;
};

struct FinishedMesh {
  IndexedMesh mesh;
  IndexedMesh removed;  // components that were too small, before smoothing
  FinishSummary summary;
};

// Extraction, placement and smoothing; components smaller than the
// options say are removed, and handles as `min_handle` says. No triangles
// intersect, once coordinates are rounded to the floats of files either. With
// normals, without colours. `surface` is not empty; `views` say how large
// pixels are, and what silhouettes show.
FinishedMesh FinalMesh(const ViewSet& views,
                       const LabeledVoxels& surface,
                       const BoundingCube& cube,
                       const FinishOptions& options,
                       const Context& context);

}  // namespace octacut
