// A mesh file with what is said of it on its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "plugin/comparison_tables.h"
#include "plugin/option_value.h"

namespace octacut {

struct MeasuredMesh {
  IndexedMesh mesh;
  ComparedMesh result;  // named; without a comparison
  // {"name", "path", "notes", "audit", "self_intersections" if counted}
  Json json;
};

enum class AllowClouds { kNo, kYes };

// Throws InputError for a file that is no mesh with faces, unless clouds of
// points are allowed.
MeasuredMesh MeasureMesh(const std::filesystem::path& path,
                         const std::string& name,
                         bool self_intersections,
                         const Context& context,
                         AllowClouds clouds = AllowClouds::kNo);

// The same of a mesh that was read already.
MeasuredMesh MeasureMesh(IndexedMesh mesh,
                         const std::filesystem::path& path,
                         const std::string& name,
                         bool self_intersections,
                         const Context& context);

// The file's name, or the whole path where another of `paths` has the same.
// Meshes and clouds with the names that COLMAP gives them, in a workspace in
// which depth_map_renderer has noted that the depth maps are octacut's, are
// marked as such: they are not COLMAP's dense result.
std::string NameAmong(const std::filesystem::path& path,
                      const std::vector<std::filesystem::path>& paths);

// The meshes that a repeatable option names: each value is a path, or several
// separated by commas where no file has the whole name. Throws OptionError for
// a value with an empty name.
std::vector<std::filesystem::path> SplitPaths(
    const std::string& option,
    const std::vector<std::filesystem::path>& values);

}  // namespace octacut
