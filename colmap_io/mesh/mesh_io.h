// Meshes from and to files: PLY, OBJ, OFF and STL, by extension; 3MF and GLB
// only to files.
#pragma once

#include <filesystem>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "colmap_io/files/atomic_files.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

enum class MeshFormat { kPly, kObj, kOff, kStl, k3mf, kGlb };

// By the extension of `path`, whatever its case. Throws OptionError that names
// the extension and lists the known ones.
MeshFormat MeshFormatOf(const std::filesystem::path& path);

struct MeshFile {
  // May be open, not manifold, and without any triangle (a point cloud).
  // Normals and colours of vertices where the file has them.
  IndexedMesh mesh;
  // What was changed or left out on the way, a line each.
  std::vector<std::string> notes;
};

// Reads a mesh of anybody's making; what each format may hold is said in
// mesh_readers.h and polygon_mesh.h. A file that begins with "ply" is read as
// PLY whatever its extension. Throws InputError "<file>: ..." that names the
// first bad element or line when the file is missing, truncated, has
// coordinates that are beyond 1e30 or not finite (PLY: vertices that are not
// finite are left out, with a note), or indices out of range, or is of a format
// that is only written.
// Counts are checked against the size of the file before memory is taken for
// them.
MeshFile ReadMesh(const std::filesystem::path& path);
MeshFile ReadMesh(std::istream& stream,
                  MeshFormat format,
                  const std::string& name);

// Writes by extension, as mesh_writers.h says. `normals` and `colors` are
// empty or of the size of `positions`. The file appears whole or not at all;
// an older one is replaced. Throws as CheckMeshPath does, and InputError when
// writing fails.
void WriteMesh(const std::filesystem::path& path, const IndexedMesh& mesh);
// Together with `files`, when these are committed.
void WriteMesh(const std::filesystem::path& path,
               const IndexedMesh& mesh,
               AtomicFiles* files);
void WriteMesh(std::ostream& stream,
               MeshFormat format,
               const IndexedMesh& mesh);

// Writes PLY whatever the extension, with `values`, one per vertex, as a float
// property `name`, when `files` are committed.
void WriteMeshWithValues(const std::filesystem::path& path,
                         IndexedMesh mesh,
                         std::vector<float> values,
                         std::string_view name,
                         AtomicFiles* files);

// To be asked before any long work: throws OptionError for an unknown
// extension and InputError when the folder is missing or cannot be written
// to, or the path is there and no regular file.
void CheckMeshPath(const std::filesystem::path& path);

}  // namespace octacut
