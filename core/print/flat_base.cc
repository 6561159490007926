#include "core/print/flat_base.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "core/mesh/bounding_box.h"
#include "core/mesh/mean_edge.h"
#include "core/mesh/self_intersections.h"
#include "core/mesh/triangle_normal.h"
#include "core/mesh/untangle.h"
#include "core/print/polygon_triangles.h"

namespace octacut {
namespace {

// A fraction of the mean edge, but, where triangles are large, no more of the
// mesh's size than a printer resolves.
constexpr double kClearance = 0.05;
constexpr double kMaxClearance = 1e-4;

double ClearanceOf(const IndexedMesh& mesh) {
  const double size = BoxOfTriangles(mesh).sizes().maxCoeff();
  return std::min(kClearance * MeanEdge(mesh), kMaxClearance * size);
}

class Cutter {
 public:
  explicit Cutter(const IndexedMesh& mesh) : mesh_(mesh) {
    out_.positions = mesh.positions;
    out_.colors = mesh.colors;
    const double clearance =
        RoundedToFloats(Eigen::Vector3d::Constant(ClearanceOf(mesh))).x();
    for (Eigen::Vector3d& position : out_.positions) {
      if (std::abs(position.z()) < clearance) {
        position.z() = position.z() >= 0 ? clearance : -clearance;
      }
    }
  }

  FlatBase Run() {
    for (const auto& triangle : mesh_.triangles) {
      Clip(triangle);
    }
    FlatBase base;
    AddBase(&base);
    Compact();
    base.mesh = std::move(out_);
    return base;
  }

 private:
  bool IsAbove(uint32_t vertex) const { return out_.positions[vertex].z() > 0; }

  // The vertex where an edge goes through the plane.
  uint32_t Crossing(uint32_t a, uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [found, is_new] = crossings_.emplace(
        uint64_t{low} << 32 | high, uint32_t(out_.positions.size()));
    if (is_new) {
      const Eigen::Vector3d& p = out_.positions[low];
      const Eigen::Vector3d& q = out_.positions[high];
      const double t = p.z() / (p.z() - q.z());
      Eigen::Vector3d place = RoundedToFloats(p + t * (q - p));
      place.z() = 0;
      out_.positions.push_back(place);
      if (!out_.colors.empty()) {
        std::array<uint8_t, 3> color;
        for (int i = 0; i < 3; ++i) {
          color[i] = uint8_t(std::lround((1 - t) * out_.colors[low][i] +
                                         t * out_.colors[high][i]));
        }
        out_.colors.push_back(color);
      }
    }
    return found->second;
  }

  void Clip(std::array<uint32_t, 3> triangle) {
    const auto num_above =
        std::count_if(triangle.begin(), triangle.end(), [&](uint32_t v) {
          return IsAbove(v);
        });
    if (num_above == 0) {
      return;
    }
    if (num_above == 3) {
      out_.triangles.push_back(triangle);
      return;
    }
    // The corner that is alone on its side comes first.
    while (IsAbove(triangle[0]) != (num_above == 1) ||
           IsAbove(triangle[1]) == (num_above == 1) ||
           IsAbove(triangle[2]) == (num_above == 1)) {
      std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    }
    const auto& [a, b, c] = triangle;
    const uint32_t ab = Crossing(a, b);
    const uint32_t ca = Crossing(c, a);
    if (num_above == 1) {
      out_.triangles.push_back({a, ab, ca});
      next_[ca] = ab;
      return;
    }
    const auto& p = out_.positions;
    if ((p[ab] - p[c]).squaredNorm() < (p[ca] - p[b]).squaredNorm()) {
      out_.triangles.push_back({ab, b, c});
      out_.triangles.push_back({ab, c, ca});
    } else {
      out_.triangles.push_back({ab, b, ca});
      out_.triangles.push_back({b, c, ca});
    }
    next_[ab] = ca;
  }

  // The loops along which the sides end, seen from below with the base to the
  // left; next_ is emptied.
  std::vector<PolygonLoop> TakeLoops() {
    std::vector<PolygonLoop> loops;
    while (!next_.empty()) {
      const uint32_t first = next_.begin()->first;
      PolygonLoop& loop = loops.emplace_back();
      for (uint32_t v = first; next_.contains(v);) {
        loop.push_back(v);
        const auto here = next_.find(v);
        v = here->second;
        next_.erase(here);
      }
    }
    return loops;
  }

  void AddBase(FlatBase* base) {
    const std::vector<PolygonLoop> loops = TakeLoops();
    std::vector<Eigen::Vector2d> points(out_.positions.size());
    for (size_t i = 0; i < points.size(); ++i) {
      // From below, x and y change places.
      points[i] = {out_.positions[i].y(), out_.positions[i].x()};
    }
    const auto triangles = TrianglesOfLoops(points, loops);
    for (const auto& triangle : triangles) {
      base->area += TriangleArea(out_, triangle);
      out_.triangles.push_back(triangle);
    }
    // A polygon of n corners and h holes has n + 2 h - 2 triangles.
    size_t num_corners = 0;
    for (const PolygonLoop& loop : loops) {
      num_corners += loop.size();
    }
    base->num_islands = (num_corners + 2 * loops.size() - triangles.size()) / 4;
  }

  // Leaves out vertices that no triangle uses any more.
  void Compact() {
    std::vector<uint32_t> numbers(out_.positions.size(), 0);
    for (const auto& triangle : out_.triangles) {
      for (const uint32_t corner : triangle) {
        numbers[corner] = 1;
      }
    }
    uint32_t count = 0;
    for (uint32_t v = 0; v < numbers.size(); ++v) {
      if (numbers[v] == 0) {
        continue;
      }
      numbers[v] = count;
      out_.positions[count] = out_.positions[v];
      if (!out_.colors.empty()) {
        out_.colors[count] = out_.colors[v];
      }
      ++count;
    }
    out_.positions.resize(count);
    out_.colors.resize(out_.colors.empty() ? 0 : count);
    for (auto& triangle : out_.triangles) {
      for (uint32_t& corner : triangle) {
        corner = numbers[corner];
      }
    }
  }

  const IndexedMesh& mesh_;
  IndexedMesh out_;
  std::unordered_map<uint64_t, uint32_t> crossings_;
  std::map<uint32_t, uint32_t> next_;  // along the loops
};

// Triangles of the base and those that have moved or been cut: all that come
// within `reach` of the plane.
std::vector<uint8_t> TrianglesAtTheCut(const IndexedMesh& mesh, double reach) {
  std::vector<uint8_t> marks(mesh.triangles.size());
  for (size_t t = 0; t < marks.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    marks[t] = std::any_of(corners.begin(), corners.end(), [&](uint32_t v) {
      return mesh.positions[v].z() <= reach;
    });
  }
  return marks;
}

}  // namespace

FlatBase CutFlatBase(const IndexedMesh& mesh, const Context& context) {
  const Phase phase(context, "flat base");
  FlatBase base = Cutter(mesh).Run();
  if (base.num_islands == 0) {
    throw InputError(
        "flat base: the cut is so close to the lowest point of the mesh that "
        "it cuts nothing off; cut higher");
  }
  const std::string failure = AuditMesh(base.mesh, context).DescribeFailure();
  if (!failure.empty()) {
    throw InputError(fmt::format(
        "flat base: the mesh is not closed after the cut ({}); cut at another "
        "height",
        failure));
  }
  const double reach = 2 * ClearanceOf(mesh);
  const size_t num_pairs =
      FindIntersectionsOfMarked(
          base.mesh, TrianglesAtTheCut(base.mesh, reach), context)
          .size();
  if (num_pairs > 0) {
    throw InputError(
        fmt::format("flat base: {} pairs of triangles intersect "
                    "at the cut; cut at another height",
                    num_pairs));
  }
  return base;
}

}  // namespace octacut
