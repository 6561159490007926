// Options of mesh_comparer that set how surfaces are compared.
#pragma once

#include "core/benchmark/compare/compare_meshes.h"
#include "core/benchmark/compare/seen_reference.h"
#include "plugin/option_manager.h"

namespace octacut {

// num_samples, thresholds, accuracy_fraction and completeness_threshold.
void DeclareMeasureOptions(OptionManager& options,
                           CompareMeshesOptions* compare);

// min_views and max_view_angle.
void DeclareSeenOptions(OptionManager& options, SeenReferenceOptions* seen);

// align and Alignment.*.
void DeclareAlignmentOptions(OptionManager& options,
                             CompareMeshesOptions* compare);

}  // namespace octacut
