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
  // Of vertices; both empty or of the size of `positions`.
  std::vector<Eigen::Vector3f> normals;
  std::vector<std::array<uint8_t, 3>> colors;  // red, green, blue
  // Of vertices, 0 .. 1: how far they can be relied upon; empty where nothing
  // is known of that. Steps that change the mesh do not keep it.
  std::vector<float> confidence;
};

}  // namespace octacut
