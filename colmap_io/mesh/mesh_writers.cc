#include "colmap_io/mesh/mesh_writers.h"

#include <Eigen/Geometry>
#include <string>

#include "colmap_io/mesh/output_buffer.h"
#include "core/mesh/triangle_normal.h"

namespace octacut {

void WritePly(const IndexedMesh& mesh,
              std::ostream& stream,
              std::string_view confidence_name) {
  const bool has_normals = !mesh.normals.empty();
  const bool has_colors = !mesh.colors.empty();
  const bool has_confidence = !mesh.confidence.empty();
  OutputBuffer out(&stream);
  out.Print("ply\nformat binary_little_endian 1.0\nelement vertex {}\n",
            mesh.positions.size());
  out.Print("property float x\nproperty float y\nproperty float z\n");
  if (has_normals) {
    out.Print("property float nx\nproperty float ny\nproperty float nz\n");
  }
  if (has_colors) {
    out.Print(
        "property uchar red\nproperty uchar green\nproperty uchar blue\n");
  }
  if (has_confidence) {
    out.Print("property float {}\n", confidence_name);
  }
  out.Print(
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.triangles.size());
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      out.Float(mesh.positions[i][axis]);
    }
    for (int axis = 0; has_normals && axis < 3; ++axis) {
      out.Float(mesh.normals[i][axis]);
    }
    for (int channel = 0; has_colors && channel < 3; ++channel) {
      out.Byte(mesh.colors[i][channel]);
    }
    if (has_confidence) {
      out.Float(mesh.confidence[i]);
    }
  }
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    out.Byte(3);
    for (const uint32_t vertex : triangle) {
      out.Uint32(vertex);
    }
  }
}

void WriteObj(const IndexedMesh& mesh, std::ostream& stream) {
  OutputBuffer out(&stream);
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const Eigen::Vector3d& p = mesh.positions[i];
    out.Print("v {} {} {}", p.x(), p.y(), p.z());
    if (!mesh.colors.empty()) {
      const std::array<uint8_t, 3>& color = mesh.colors[i];
      out.Print(" {:.6f} {:.6f} {:.6f}",
                color[0] / 255.0,
                color[1] / 255.0,
                color[2] / 255.0);
    }
    out.Print("\n");
  }
  for (const Eigen::Vector3f& n : mesh.normals) {
    out.Print("vn {} {} {}\n", n.x(), n.y(), n.z());
  }
  const bool has_normals = !mesh.normals.empty();
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    out.Print("f");
    for (const uint32_t vertex : triangle) {
      const uint64_t number = uint64_t{vertex} + 1;
      if (has_normals) {
        out.Print(" {}//{}", number, number);
      } else {
        out.Print(" {}", number);
      }
    }
    out.Print("\n");
  }
}

void WriteOff(const IndexedMesh& mesh, std::ostream& stream) {
  OutputBuffer out(&stream);
  const bool has_colors = !mesh.colors.empty();
  out.Print("{}\n{} {} 0\n",
            has_colors ? "COFF" : "OFF",
            mesh.positions.size(),
            mesh.triangles.size());
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const Eigen::Vector3d& p = mesh.positions[i];
    out.Print("{} {} {}", p.x(), p.y(), p.z());
    if (has_colors) {
      const std::array<uint8_t, 3>& color = mesh.colors[i];
      out.Print(" {} {} {} 255", color[0], color[1], color[2]);
    }
    out.Print("\n");
  }
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    out.Print("3 {} {} {}\n", triangle[0], triangle[1], triangle[2]);
  }
}

void WriteStl(const IndexedMesh& mesh, std::ostream& stream) {
  OutputBuffer out(&stream);
  // Must not begin with "solid": some readers would take it for text.
  out.Print("{:80}", "binary STL written by octacut");
  out.Uint32(static_cast<uint32_t>(mesh.triangles.size()));
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.positions[triangle[0]];
    const Eigen::Vector3d& b = mesh.positions[triangle[1]];
    const Eigen::Vector3d& c = mesh.positions[triangle[2]];
    Eigen::Vector3d normal = AreaNormal(mesh, triangle);
    normal.stableNormalize();
    for (const Eigen::Vector3d& vector : {normal, a, b, c}) {
      for (int axis = 0; axis < 3; ++axis) {
        out.Float(vector[axis]);
      }
    }
    out.Byte(0);
    out.Byte(0);
  }
}

}  // namespace octacut
