// Texturing as commands run it: options, files and report.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/images/photograph_files.h"
#include "colmap_io/mesh/textured_mesh_io.h"
#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/texture/texture_mesh.h"
#include "plugin/file_roles.h"
#include "plugin/option_manager.h"

namespace octacut {

struct TexturingArguments {
  TexturingOptions texture;
  TexturedMeshOptions images;
  std::filesystem::path output_path;
  std::filesystem::path picture_path;  // empty: no picture
  // The full mesh whose normals become a normal map; empty: no normal map.
  std::filesystem::path normal_map_path;
  // Each such photograph is left out and compared with the result; 0: none.
  int hold_out = 0;
  // Meshes whose vertex colours are compared with these photographs, too.
  std::vector<std::filesystem::path> compare_paths;

  void Declare(OptionManager& options);
  // Also that nothing that is written replaces one of `files`, which it joins;
  // to be asked before any long work.
  void Check(FileRoles* files) const;
};

struct NamedMesh {
  const IndexedMesh& mesh;
  std::string name;  // for messages
};

// Textures `mesh` from the workspace's photographs and writes all files, when
// `files` are committed. Returns the section of the report; `photographs.box`
// need not be set.
Json TextureAndWrite(const NamedMesh& mesh,
                     const std::filesystem::path& workspace_path,
                     PhotographOptions photographs,
                     const TexturingArguments& arguments,
                     const Context& context,
                     AtomicFiles* files);

}  // namespace octacut
