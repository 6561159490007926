// Points of a surface some steps away from another one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/mesh/vertex_corners.h"

namespace octacut {

// Visits points ring by ring, where `neighbors` are those of SurfacePoints. One
// object serves one thread.
class PointRings {
 public:
  // Keeps a reference to `neighbors`.
  PointRings(const VertexCorners& neighbors, size_t num_points)
      : neighbors_(neighbors), reached_from_(num_points, kNowhere) {}

  // Calls `visit` with each point that is `first` to `last` steps away from
  // `point`, which itself is 0 steps away. `point` is another one in every
  // call.
  template <typename Visit>
  void ForEach(uint32_t point, int first, int last, const Visit& visit) {
    front_.assign(1, point);
    reached_from_[point] = point;
    if (first == 0) {
      visit(point);
    }
    for (int ring = 1; ring <= last; ++ring) {
      next_.clear();
      for (const uint32_t from : front_) {
        for (const uint32_t to : neighbors_.Of(from)) {
          if (reached_from_[to] != point) {
            reached_from_[to] = point;
            next_.push_back(to);
            if (ring >= first) {
              visit(to);
            }
          }
        }
      }
      front_.swap(next_);
    }
  }

 private:
  static constexpr uint32_t kNowhere = std::numeric_limits<uint32_t>::max();

  const VertexCorners& neighbors_;
  std::vector<uint32_t> reached_from_;
  std::vector<uint32_t> front_;
  std::vector<uint32_t> next_;
};

}  // namespace octacut
