// Writes COLMAP sparse models, binary and text, as COLMAP 3.x does: without
// rigs and frames, which newer versions make up themselves.
#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "colmap_io/model/sparse_model.h"

namespace octacut {

// Write cameras, images and points3D into a folder, which is created where
// missing. The files take their names only once all are complete. The text
// has as many digits as it takes to read the same doubles again.
//
// Throw InputError when the model is not consistent (CheckSparseModel), when
// a name cannot be written in the format, or when other files of the folder
// would keep COLMAP from reading what is written (rigs.*, frames.*; .bin
// files beside new text); Error when a file cannot be written.
void WriteSparseModelBinary(const SparseModel& model,
                            const std::filesystem::path& folder);
void WriteSparseModelText(const SparseModel& model,
                          const std::filesystem::path& folder);

// One file's content to a stream; the caller checks the stream afterwards.
void WriteCamerasBinary(const std::vector<SparseCamera>& cameras,
                        std::ostream& stream);
void WriteImagesBinary(const std::vector<SparseImage>& images,
                       std::ostream& stream);
void WritePointsBinary(const std::vector<SparsePoint>& points,
                       std::ostream& stream);
void WriteCamerasText(const std::vector<SparseCamera>& cameras,
                      std::ostream& stream);
void WriteImagesText(const std::vector<SparseImage>& images,
                     std::ostream& stream);
void WritePointsText(const std::vector<SparsePoint>& points,
                     std::ostream& stream);

}  // namespace octacut
