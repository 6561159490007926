// Brings meshes into the frame of a reference by photographs that the sparse
// models of both frames have.
#pragma once

#include "colmap_io/model/sparse_model.h"
#include "core/base/context.h"
#include "core/benchmark/compare/shared_cameras.h"

namespace octacut {

// By the images of the same name. context.Info says how many there are and how
// well they agree; warns if fewer than half do. Throws InputError as
// AlignSharedCameras does.
SharedCameraAlignment AlignBySharedViews(const SparseModel& model,
                                         const SparseModel& reference,
                                         const Context& context);

}  // namespace octacut
