// Vertices with one pair of texture coordinates each, as formats need them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/texture/textured_mesh.h"

namespace octacut {

struct CornerOfTriangle {
  uint32_t triangle;
  uint32_t corner;
};

// A vertex for each vertex of the mesh and chart that it is in.
struct SplitVertices {
  std::vector<uint32_t> vertices;         // of the mesh
  std::vector<CornerOfTriangle> corners;  // one that each vertex stands for
  std::vector<std::array<uint32_t, 3>> triangles;
};

// Those of one page.
SplitVertices SplitPage(const TexturedMesh& mesh, uint32_t page);

}  // namespace octacut
