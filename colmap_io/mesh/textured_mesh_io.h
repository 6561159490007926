// Textured meshes to files: GLB, OBJ and PLY, by extension.
#pragma once

#include <filesystem>
#include <vector>

#include "colmap_io/files/atomic_files.h"
#include "core/texture/textured_mesh.h"

namespace octacut {

enum class TextureImageFormat { kPng, kJpeg };

struct TexturedMeshOptions {
  TextureImageFormat image_format = TextureImageFormat::kPng;
};

// Throws OptionError for an extension other than .glb, .obj and .ply.
void CheckTexturedMeshPath(const std::filesystem::path& path);

// All files that a mesh of at most `max_pages` pages may be written to: `path`
// first.
std::vector<std::filesystem::path> TexturedMeshPaths(
    const std::filesystem::path& path,
    const TexturedMeshOptions& options,
    int max_pages,
    bool has_normal_map);

// Whether the format of this extension has normal maps.
bool CanHoldNormalMaps(const std::filesystem::path& path);

// Writes by extension; all files appear when `files` are committed:
// - .glb: one file with the images in it, and with the normal maps.
// - .obj: beside it NAME.mtl and an image for each page, NAME_texture.png, or
//   NAME_texture_0.png and so on if there are several; coordinates with all
//   their digits. Normal maps become NAME_normal.png (map_Bump).
// - .ply: binary, with images beside it as for .obj; texture coordinates of the
//   corners of faces (texcoord, and texnumber if there are several pages) and
//   comments TextureFile, as MeshLab reads and writes them. No normal maps.
// Images as JPEG end with .jpg; normal maps are always PNG. Returns the paths
// of what was written.
std::vector<std::filesystem::path> WriteTexturedMesh(
    const std::filesystem::path& path,
    const TexturedMesh& mesh,
    const TexturedMeshOptions& options,
    AtomicFiles* files);

}  // namespace octacut
