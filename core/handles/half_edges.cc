#include "core/handles/half_edges.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace octacut {

HalfEdges::HalfEdges(size_t num_vertices,
                     std::span<const std::array<uint32_t, 3>> triangles,
                     const Context& context)
    : triangles_(triangles),
      leaving_(FindVertexCorners(num_vertices, triangles)),
      opposite_(3 * triangles.size()) {
  constexpr size_t kGrain = 1 << 15;
  ParallelEach(context, opposite_.size(), kGrain, [&](size_t i) {
    const auto h = uint32_t(i);
    const std::span<const uint32_t> leaving = Leaving(End(h));
    const auto opposite =
        std::find_if(leaving.begin(), leaving.end(), [&](uint32_t other) {
          return End(other) == Origin(h);
        });
    if (opposite == leaving.end()) {
      throw InvariantError(
          fmt::format("triangle {} has an edge without an opposite", h / 3));
    }
    opposite_[h] = *opposite;
  });
}

}  // namespace octacut
