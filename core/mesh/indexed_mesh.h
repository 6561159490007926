// A triangle mesh as plain arrays: what is exchanged between steps and files.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

namespace octacut {

struct IndexedMesh {
  std::vector<Eigen::Vector3d> positions;  // world coordinates
  // Corner indices, counter-clockwise seen from outside.
  std::vector<std::array<uint32_t, 3>> triangles;
  // Values of the vertices; both empty or as many as `positions`.
  std::vector<Eigen::Vector3f> normals;
  std::vector<std::array<uint8_t, 3>> colors;  // red, green, blue
  // How far each vertex can be relied upon, 0 .. 1; empty where nothing is
  // known of that. Steps that change the mesh do not keep it.
  std::vector<float> confidence;
};

}  // namespace octacut
