// OBJ with materials, and PLY with texture coordinates, onto streams.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "core/texture/textured_mesh.h"

namespace octacut {

// Files of the pages, in the folder of the mesh; `normals` is empty without
// normal maps.
struct PageNames {
  std::vector<std::string> colors;
  std::vector<std::string> normals;
};

// A diffuse material page_<i> for each page.
void WriteMtl(const PageNames& names, std::ostream& stream);

// v, vt, vn, f v/vt/vn, grouped by page; `materials` is the name of the file
// of materials.
void WriteTexturedObj(const TexturedMesh& mesh,
                      const std::string& materials,
                      std::ostream& stream);

// Binary little endian: vertices as WritePly has them (mesh_writers.h) without
// colours, faces with texcoord and, for several pages, texnumber.
void WriteTexturedPly(const TexturedMesh& mesh,
                      const PageNames& names,
                      std::ostream& stream);

}  // namespace octacut
