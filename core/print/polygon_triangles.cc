#include "core/print/polygon_triangles.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "core/mesh/exact_predicates.h"

namespace octacut {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using Triangles = std::vector<std::array<uint32_t, 3>>;

// The sign of the area of three points.
int Turn(const Points& points, uint32_t a, uint32_t b, uint32_t c) {
  const auto lifted = [&](uint32_t i) {
    return Eigen::Vector3d(points[i].x(), points[i].y(), 0);
  };
  return Orient2d(lifted(a), lifted(b), lifted(c), 2);
}

double TwiceArea(const Points& points, const PolygonLoop& loop) {
  double area = 0;
  for (size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d& p = points[loop[i]];
    const Eigen::Vector2d& q = points[loop[(i + 1) % loop.size()]];
    area += p.x() * q.y() - p.y() * q.x();
  }
  return area;
}

// By the crossings of a ray towards +x.
bool Contains(const Points& points, const PolygonLoop& loop, uint32_t point) {
  bool is_inside = false;
  for (size_t i = 0; i < loop.size(); ++i) {
    uint32_t low = loop[i];
    uint32_t high = loop[(i + 1) % loop.size()];
    if (points[low].y() > points[high].y()) {
      std::swap(low, high);
    }
    if (points[low].y() <= points[point].y() &&
        points[point].y() < points[high].y() &&
        Turn(points, low, high, point) > 0) {
      is_inside = !is_inside;
    }
  }
  return is_inside;
}

// On the line through a and b, of which `point` is a point: between them?
bool IsBetween(const Points& points, uint32_t a, uint32_t b, uint32_t point) {
  const Eigen::Vector2d low = points[a].cwiseMin(points[b]);
  const Eigen::Vector2d high = points[a].cwiseMax(points[b]);
  return (low.array() <= points[point].array()).all() &&
         (points[point].array() <= high.array()).all();
}

// Whether the closed segments have a point in common that is no common end.
bool SegmentsMeet(
    const Points& points, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  const int side_c = Turn(points, a, b, c);
  const int side_d = Turn(points, a, b, d);
  const bool shares = a == c || a == d || b == c || b == d;
  if (shares) {
    const uint32_t far_1 = c == a || c == b ? d : c;
    const uint32_t far_2 = a == c || a == d ? b : a;
    return (Turn(points, a, b, far_1) == 0 && IsBetween(points, a, b, far_1)) ||
           (Turn(points, c, d, far_2) == 0 && IsBetween(points, c, d, far_2));
  }
  const int side_a = Turn(points, c, d, a);
  const int side_b = Turn(points, c, d, b);
  if (side_a * side_b < 0 && side_c * side_d < 0) {
    return true;
  }
  return (side_c == 0 && IsBetween(points, a, b, c)) ||
         (side_d == 0 && IsBetween(points, a, b, d)) ||
         (side_a == 0 && IsBetween(points, c, d, a)) ||
         (side_b == 0 && IsBetween(points, c, d, b));
}

// One outer loop and its holes.
class PolygonFiller {
 public:
  PolygonFiller(const Points& points,
                PolygonLoop outer,
                std::vector<PolygonLoop> holes)
      : points_(points), ring_(std::move(outer)), holes_(std::move(holes)) {}

  // Nothing where it cannot be done.
  std::optional<Triangles> Run() {
    // Holes are joined from right to left: what the rightmost corner of a hole
    // sees on its right is then a part of the ring already.
    for (PolygonLoop& hole : holes_) {
      std::rotate(hole.begin(),
                  std::max_element(hole.begin(),
                                   hole.end(),
                                   [&](uint32_t a, uint32_t b) {
                                     return points_[a].x() < points_[b].x();
                                   }),
                  hole.end());
    }
    std::sort(holes_.begin(), holes_.end(), [&](const auto& a, const auto& b) {
      return points_[a[0]].x() > points_[b[0]].x();
    });
    for (size_t i = 0; i < holes_.size(); ++i) {
      if (!Bridge(i)) {
        return std::nullopt;
      }
    }
    return CutEars();
  }

 private:
  size_t Next(size_t i) const { return i + 1 == ring_.size() ? 0 : i + 1; }
  size_t Before(size_t i) const { return (i == 0 ? ring_.size() : i) - 1; }

  // Whether `point` is seen from corner i of the ring into its inside.
  bool IsInCorner(size_t i, uint32_t point) const {
    const uint32_t before = ring_[Before(i)];
    const uint32_t here = ring_[i];
    const uint32_t next = ring_[Next(i)];
    const bool left_of_first = Turn(points_, before, here, point) > 0;
    const bool left_of_second = Turn(points_, here, next, point) > 0;
    return Turn(points_, before, here, next) > 0
               ? left_of_first && left_of_second
               : left_of_first || left_of_second;
  }

  bool IsBlocked(const PolygonLoop& loop, uint32_t a, uint32_t b) const {
    for (size_t i = 0; i < loop.size(); ++i) {
      const uint32_t c = loop[i];
      const uint32_t d = loop[i + 1 == loop.size() ? 0 : i + 1];
      if (SegmentsMeet(points_, a, b, c, d)) {
        return true;
      }
    }
    return false;
  }

  // Joins the ring and a hole by an edge that both go along, at the nearest
  // corner that the hole's rightmost one sees.
  bool Bridge(size_t number) {
    const PolygonLoop& hole = holes_[number];
    std::vector<size_t> order(ring_.size());
    std::iota(order.begin(), order.end(), size_t{0});
    const Eigen::Vector2d& from = points_[hole[0]];
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
      const double distance_a = (points_[ring_[a]] - from).squaredNorm();
      const double distance_b = (points_[ring_[b]] - from).squaredNorm();
      return distance_a != distance_b ? distance_a < distance_b : a < b;
    });
    for (const size_t i : order) {
      if (!IsInCorner(i, hole[0]) || IsBlocked(ring_, hole[0], ring_[i]) ||
          std::any_of(holes_.begin() + std::ptrdiff_t(number),
                      holes_.end(),
                      [&](const PolygonLoop& other) {
                        return IsBlocked(other, hole[0], ring_[i]);
                      })) {
        continue;
      }
      PolygonLoop detour(hole);
      detour.push_back(hole[0]);
      detour.push_back(ring_[i]);
      ring_.insert(
          ring_.begin() + std::ptrdiff_t(i) + 1, detour.begin(), detour.end());
      return true;
    }
    return false;
  }

  // No other corner lies in the triangle or on its border.
  bool IsEar(size_t i) const {
    const uint32_t a = ring_[Before(i)];
    const uint32_t b = ring_[i];
    const uint32_t c = ring_[Next(i)];
    if (Turn(points_, a, b, c) <= 0) {
      return false;
    }
    const Eigen::Vector2d low =
        points_[a].cwiseMin(points_[b]).cwiseMin(points_[c]);
    const Eigen::Vector2d high =
        points_[a].cwiseMax(points_[b]).cwiseMax(points_[c]);
    return std::none_of(ring_.begin(), ring_.end(), [&](uint32_t p) {
      return p != a && p != b && p != c &&
             (low.array() <= points_[p].array()).all() &&
             (points_[p].array() <= high.array()).all() &&
             Turn(points_, a, b, p) >= 0 && Turn(points_, b, c, p) >= 0 &&
             Turn(points_, c, a, p) >= 0;
    });
  }

  std::optional<Triangles> CutEars() {
    Triangles triangles;
    size_t i = 0;
    size_t num_refused = 0;
    while (ring_.size() >= 3) {
      if (num_refused == ring_.size()) {
        return std::nullopt;
      }
      if (!IsEar(i)) {
        ++num_refused;
        i = Next(i);
        continue;
      }
      num_refused = 0;
      triangles.push_back({ring_[Before(i)], ring_[i], ring_[Next(i)]});
      ring_.erase(ring_.begin() + std::ptrdiff_t(i));
      // Cutting on two corners farther spares a fan of needles.
      i = (i + 1) % ring_.size();
    }
    return triangles;
  }

  const Points& points_;
  PolygonLoop ring_;
  std::vector<PolygonLoop> holes_;
};

}  // namespace

Triangles TrianglesOfLoops(const Points& points,
                           const std::vector<PolygonLoop>& loops) {
  std::vector<double> areas(loops.size());
  for (size_t i = 0; i < loops.size(); ++i) {
    areas[i] = TwiceArea(points, loops[i]);
  }
  std::vector<std::vector<PolygonLoop>> holes(loops.size());
  for (size_t hole = 0; hole < loops.size(); ++hole) {
    if (areas[hole] > 0) {
      continue;
    }
    std::optional<size_t> around;
    for (size_t outer = 0; outer < loops.size(); ++outer) {
      if (areas[outer] > 0 && (!around || areas[outer] < areas[*around]) &&
          Contains(points, loops[outer], loops[hole][0])) {
        around = outer;
      }
    }
    if (!around) {
      return {};
    }
    holes[*around].push_back(loops[hole]);
  }
  Triangles triangles;
  for (size_t outer = 0; outer < loops.size(); ++outer) {
    if (areas[outer] > 0) {
      const auto part =
          PolygonFiller(points, loops[outer], std::move(holes[outer])).Run();
      if (!part) {
        return {};
      }
      triangles.insert(triangles.end(), part->begin(), part->end());
    }
  }
  return triangles;
}

}  // namespace octacut
