// The half-edges of a closed mesh: 3 * t + i leads from corner i of triangle t
// to the next one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {

class HalfEdges {
 public:
  static constexpr uint32_t kNone = 0xffffffffu;

  // Keeps a reference to the triangles. The mesh must be closed, oriented and
  // edge-manifold; throws InvariantError for a half-edge without an opposite.
  HalfEdges(size_t num_vertices,
            std::span<const std::array<uint32_t, 3>> triangles,
            const Context& context);

  uint32_t Size() const { return uint32_t(opposite_.size()); }
  size_t NumVertices() const { return leaving_.offsets.size() - 1; }

  uint32_t Origin(uint32_t h) const { return triangles_[h / 3][h % 3]; }
  uint32_t End(uint32_t h) const { return triangles_[h / 3][(h + 1) % 3]; }
  uint32_t Opposite(uint32_t h) const { return opposite_[h]; }
  // The next one around its origin, counter-clockwise seen from outside.
  uint32_t NextAround(uint32_t h) const {
    return opposite_[h - h % 3 + (h + 2) % 3];
  }
  // Those that leave a vertex, ascending.
  std::span<const uint32_t> Leaving(uint32_t vertex) const {
    return leaving_.Of(vertex);
  }

 private:
  std::span<const std::array<uint32_t, 3>> triangles_;
  VertexCorners leaving_;
  std::vector<uint32_t> opposite_;
};

}  // namespace octacut
