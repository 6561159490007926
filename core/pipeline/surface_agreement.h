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

// Compares the views at samples that are `sample_width` voxels of `surface`
// wide, or one pixel where pixels are wider. Empty where `surface` is or where
// no view has its centre in front of the camera. `phase` names the progress.
MeasuredSurface MeasureSurface(const ViewSet& views,
                               const LabeledVoxels& surface,
                               double sample_width,
                               const char* phase,
                               const RefineOptions& options,
                               const Context& context);

}  // namespace octacut
