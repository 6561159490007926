// Writes binary COLMAP sparse models as COLMAP 3.x does: without rigs and
// frames, which newer versions make up themselves.
#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "colmap_io/model/sparse_model.h"

namespace octacut {

// Writes cameras, images and points3D into a folder, which is created where
// missing. The files take their names only once all are complete.
//
// Throws InputError when the model is not consistent (CheckSparseModel), when
// a name holds a NUL, or when other files of the folder would keep COLMAP from
// reading what is written (rigs.bin, frames.bin); Error when a file cannot be
// written.
void WriteSparseModelBinary(const SparseModel& model,
                            const std::filesystem::path& folder);

// One file's content to a stream; the caller checks the stream afterwards.
void WriteCamerasBinary(const std::vector<SparseCamera>& cameras,
                        std::ostream& stream);
void WriteImagesBinary(const std::vector<SparseImage>& images,
                       std::ostream& stream);
void WritePointsBinary(const std::vector<SparsePoint>& points,
                       std::ostream& stream);

}  // namespace octacut
