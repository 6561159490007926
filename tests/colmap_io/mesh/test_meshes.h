// Meshes and shorthands of the tests in this folder.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "colmap_io/mesh/mesh_io.h"
#include "core/base/error.h"
#include "tests/colmap_io/files/temporary_folder.h"

namespace octacut {

// An octahedron with coordinates that no float holds exactly.
inline IndexedMesh TestMesh(bool with_normals, bool with_colors) {
  IndexedMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      Eigen::Vector3d position(0.1, -0.2, 1e-7);
      position[axis] += sign * 1.3;
      mesh.positions.push_back(position);
      if (with_normals) {
        mesh.normals.push_back(sign * Eigen::Vector3f::Unit(axis));
      }
      if (with_colors) {
        const auto shade = static_cast<uint8_t>(40 * mesh.positions.size());
        mesh.colors.push_back({shade, 255, static_cast<uint8_t>(axis)});
      }
    }
  }
  mesh.triangles = {{0, 2, 4},
                    {2, 1, 4},
                    {1, 3, 4},
                    {3, 0, 4},
                    {2, 0, 5},
                    {1, 2, 5},
                    {3, 1, 5},
                    {0, 3, 5}};
  return mesh;
}

// Number by number: GCC 12 makes nothing of the two casts of whole vectors.
inline Eigen::Vector3d RoundedToFloat(const Eigen::Vector3d& position) {
  Eigen::Vector3d rounded;
  for (int axis = 0; axis < 3; ++axis) {
    const volatile float value = static_cast<float>(position[axis]);
    rounded[axis] = value;
  }
  return rounded;
}

inline MeshFile ReadText(const std::string& text, MeshFormat format) {
  std::istringstream stream(text);
  return ReadMesh(stream, format, "test");
}

inline std::string WriteText(const IndexedMesh& mesh, MeshFormat format) {
  std::ostringstream stream;
  WriteMesh(stream, format, mesh);
  return stream.str();
}

// The message of the InputError that reading throws; empty if it does not.
inline std::string ReadError(const std::string& text, MeshFormat format) {
  try {
    ReadText(text, format);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace octacut
