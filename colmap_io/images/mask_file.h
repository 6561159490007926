// Where the mask of a photograph is.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace octacut {

// Throws InputError that names both where two files, both a mask of the image,
// say different things.
void RequireSameMask(const std::filesystem::path& a,
                     const std::filesystem::path& b,
                     const std::string& image_name);

// The mask of image `image_name` (as the model has it, may hold folders) in
// folder `mask_path`: the first that exists of, for abc/012.jpg,
//   abc/012.jpg.png   COLMAP
//   abc/012.png       newer COLMAP
//   abc/012.mask.png  OpenMVS
//   abc/012_mask.png
//   abc/mask_012.png
//   abc/012.jpg       the very same name
// and of the others with .jpg or .jpeg; extensions may be in capitals. Never
// `image_path`/`image_name` itself.
//
// Throws InputError that names both when another one of them says something
// else.
std::optional<std::filesystem::path> FindMaskFile(
    const std::filesystem::path& mask_path,
    const std::string& image_name,
    const std::filesystem::path& image_path);

}  // namespace octacut
