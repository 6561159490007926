// Uses a bit of each layer of the installed libraries: a mesh is written,
// read back and its rays are cast.
#include <cstdio>
#include <sstream>

#include "colmap_io/mesh/mesh_io.h"
#include "core/base/context.h"
#include "core/base/morton.h"
#include "core/base/parallel.h"
#include "core/benchmark/synthetic/objects.h"
#include "core/benchmark/synthetic/polygonize.h"

int main() {
  const octacut::Context context(2);
  octacut::PolygonizeOptions options;
  options.resolution = 20;
  const octacut::IndexedMesh mesh =
      octacut::Polygonize(octacut::MakeObject("torus").shape, options, context);
  std::stringstream file;
  octacut::WriteMesh(file, octacut::MeshFormat::kPly, mesh);
  const octacut::MeshFile read =
      octacut::ReadMesh(file, octacut::MeshFormat::kPly, "torus.ply");
  std::printf("%zu triangles\n", read.mesh.triangles.size());
  return read.mesh.triangles.size() == mesh.triangles.size() ? 0 : 1;
}
