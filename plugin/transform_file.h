// Similarities as text: a 4 x 4 matrix, row by row, as CloudCompare and other
// programs write and read it.
#pragma once

#include <filesystem>

#include "colmap_io/files/atomic_files.h"
#include "core/mesh/similarity.h"
#include "plugin/option_value.h"

namespace octacut {

// Throws InputError that names the file and what is wrong: not 16 numbers, a
// last row that is not 0 0 0 1, or a linear part that is no rotation times a
// positive scale (to 1e-5).
Similarity3d ReadTransform(const std::filesystem::path& path);

// With all digits; the file appears when `files` are committed.
void WriteTransform(const std::filesystem::path& path,
                    const Similarity3d& transform,
                    AtomicFiles* files);

// The matrix as four rows of four numbers.
Json TransformToJson(const Similarity3d& transform);

}  // namespace octacut
