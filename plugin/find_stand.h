// What an object stands on, from sparse points and photographs.
#pragma once

#include "colmap_io/images/segmentation_files.h"
#include "colmap_io/model/sparse_model.h"
#include "core/base/context.h"

namespace octacut {

// Finds the plane that the object stands on and notes it in `files->input`: the
// floor, the stand's pixels of each view, and of views of a turntable the
// pixels that show its sparse points. If there is none, throws InputError if it
// `is_required`, else leaves `files` as it is. A plane that is not required
// must have something on it in the photographs (IsStand).
void FindStand(const SparseModel& model,
               bool is_required,
               const Context& context,
               SegmentationFiles* files);

}  // namespace octacut
