#include "colmap_io/mesh/textured_writers.h"

#include "colmap_io/mesh/output_buffer.h"
#include "colmap_io/mesh/split_vertices.h"

namespace octacut {

void WriteMtl(const PageNames& names, std::ostream& stream) {
  OutputBuffer out(&stream);
  for (size_t page = 0; page < names.colors.size(); ++page) {
    // Nothing shines: highlights are part of the photographs.
    out.Print("newmtl page_{}\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\n", page);
    out.Print("map_Kd {}\n", names.colors[page]);
    if (!names.normals.empty()) {
      out.Print("map_Bump {}\n", names.normals[page]);
    }
    out.Print("\n");
  }
}

void WriteTexturedObj(const TexturedMesh& mesh,
                      const std::string& materials,
                      std::ostream& stream) {
  OutputBuffer out(&stream);
  out.Print("mtllib {}\n", materials);
  for (const Eigen::Vector3d& p : mesh.mesh.positions) {
    out.Print("v {} {} {}\n", p.x(), p.y(), p.z());
  }
  for (const Eigen::Vector3f& n : mesh.mesh.normals) {
    out.Print("vn {} {} {}\n", n.x(), n.y(), n.z());
  }
  uint64_t first = 1;  // texture coordinates before this page
  for (uint32_t page = 0; page < mesh.pages.size(); ++page) {
    const SplitVertices split = SplitPage(mesh, page);
    for (const CornerOfTriangle& corner : split.corners) {
      const Eigen::Vector2f& uv =
          mesh.texcoords[corner.triangle][corner.corner];
      // OBJ counts from the bottom.
      out.Print("vt {} {}\n", uv.x(), 1 - uv.y());
    }
    out.Print("usemtl page_{}\n", page);
    for (size_t i = 0; i < split.triangles.size(); ++i) {
      out.Print("f");
      for (size_t k = 0; k < 3; ++k) {
        const uint64_t vertex =
            uint64_t{split.vertices[split.triangles[i][k]]} + 1;
        out.Print(" {}/{}/{}", vertex, first + split.triangles[i][k], vertex);
      }
      out.Print("\n");
    }
    first += split.corners.size();
  }
}

void WriteTexturedPly(const TexturedMesh& mesh,
                      const PageNames& names,
                      std::ostream& stream) {
  OutputBuffer out(&stream);
  out.Print("ply\nformat binary_little_endian 1.0\n");
  for (const std::string& name : names.colors) {
    out.Print("comment TextureFile {}\n", name);
  }
  out.Print("element vertex {}\n", mesh.mesh.positions.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) {
    out.Print("property float {}\n", name);
  }
  out.Print(
      "element face {}\nproperty list uchar int vertex_indices\n"
      "property list uchar float texcoord\n",
      mesh.mesh.triangles.size());
  const bool has_numbers = names.colors.size() > 1;
  if (has_numbers) {
    out.Print("property int texnumber\n");
  }
  out.Print("end_header\n");
  for (size_t v = 0; v < mesh.mesh.positions.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      out.Float(mesh.mesh.positions[v][axis]);
    }
    for (int axis = 0; axis < 3; ++axis) {
      out.Float(double(mesh.mesh.normals[v][axis]));
    }
  }
  for (size_t f = 0; f < mesh.mesh.triangles.size(); ++f) {
    out.Byte(3);
    for (const uint32_t corner : mesh.mesh.triangles[f]) {
      out.Uint32(corner);
    }
    out.Byte(6);
    for (const Eigen::Vector2f& uv : mesh.texcoords[f]) {
      out.Float(double(uv.x()));
      out.Float(1 - double(uv.y()));
    }
    if (has_numbers) {
      out.Uint32(mesh.PageOf(f));
    }
  }
}

}  // namespace octacut
