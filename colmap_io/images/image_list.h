// The images that a user wants to be used, as COLMAP's image_list_path has
// them.
#pragma once

#include <filesystem>

#include "colmap_io/model/sparse_model.h"

namespace octacut {

// Removes the images that the text file does not list, one name a line, as in
// the model; blanks around it and empty lines do not count. Tracks of points
// still name images that are gone. Throws InputError, with file, line and name,
// for a name that is no image of the model, and for a file that cannot be read
// or lists nothing.
void KeepListedImages(const std::filesystem::path& list_path,
                      SparseModel* model);

}  // namespace octacut
