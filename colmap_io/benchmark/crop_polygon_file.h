// The crop volume of a scene of Tanks and Temples.
#pragma once

#include <filesystem>

#include "core/benchmark/protocols/crop_polygon.h"

namespace octacut {

// Reads Open3D's SelectionPolygonVolume, a JSON file with "orthogonal_axis" (X,
// Y or Z), "axis_min", "axis_max" and "bounding_polygon", a list of at least
// three points. Throws InputError that names the file and the field.
CropPolygon ReadCropPolygon(const std::filesystem::path& path);

}  // namespace octacut
