// How well the views agree about the surface of a labelling.
#pragma once

#include "core/base/context.h"
#include "core/grid/labeled_voxels.h"
#include "core/mesh/indexed_mesh.h"
#include "core/refine/agreement.h"
#include "core/refine/refine_options.h"
#include "core/views/view_set.h"

namespace octacut {

struct MeasuredSurface {
  IndexedMesh mesh;  // unit coordinates
  SurfaceAgreement agreement;
};

// In images whose pixels are so wide, in voxels of `surface`, or as given where
// their own are wider. Empty where no view sees the surface's centre.
MeasuredSurface MeasureSurface(const ViewSet& views,
                               const LabeledVoxels& surface,
                               double sample_width,
                               const char* phase,
                               const RefineOptions& options,
                               const Context& context);

}  // namespace octacut
