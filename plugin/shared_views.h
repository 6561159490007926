// Brings meshes into the frame of a reference by photographs that the sparse
// models of both frames have.
#pragma once

#include <filesystem>
#include <string>

#include "colmap_io/model/sparse_model.h"
#include "core/base/context.h"
#include "core/benchmark/compare/shared_cameras.h"
#include "plugin/option_value.h"

namespace octacut {

// By the images of the same name. context.Info says how many there are and how
// well they agree; warns if they are apart by a twentieth of their spread.
// Throws InputError as AlignSharedCameras does.
SharedCameraAlignment AlignBySharedViews(const SparseModel& model,
                                         const SparseModel& reference,
                                         const Context& context);

// A sentence of the page about what AlignBySharedViews has found.
std::string SharedViewsLine(const SharedCameraAlignment& alignment,
                            const std::filesystem::path& model_path,
                            const std::filesystem::path& reference_path);

Json SharedViewsToJson(const SharedCameraAlignment& alignment);

}  // namespace octacut
