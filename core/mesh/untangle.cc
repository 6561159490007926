#include "core/mesh/untangle.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/mesh/self_intersections.h"

namespace octacut {
namespace {

// Pairs of triangles that intersect, of which one at least has moved since the
// search before, or `start`.
class NewIntersections {
 public:
  explicit NewIntersections(const std::vector<Eigen::Vector3d>& start)
      : before_(start) {}

  std::vector<std::array<uint32_t, 2>> Find(const IndexedMesh& mesh,
                                            const Context& context) {
    std::vector<uint8_t> has_moved(mesh.triangles.size());
    for (size_t i = 0; i < has_moved.size(); ++i) {
      const auto& corners = mesh.triangles[i];
      has_moved[i] =
          std::any_of(corners.begin(), corners.end(), [&](uint32_t v) {
            return mesh.positions[v] != before_[v];
          });
    }
    before_ = mesh.positions;
    return FindIntersectionsOfMarked(mesh, has_moved, context);
  }

 private:
  std::vector<Eigen::Vector3d> before_;
};

// Returns how many vertices were moved back.
size_t WithdrawFromIntersections(const std::vector<Eigen::Vector3d>& start,
                                 const Context& context,
                                 NewIntersections* intersections,
                                 IndexedMesh* mesh) {
  const std::vector<Eigen::Vector3d> target = mesh->positions;
  std::vector<uint8_t> steps(start.size());
  size_t num_withdrawn = 0;
  while (true) {
    std::vector<uint32_t> vertices;
    for (const auto& pair : intersections->Find(*mesh, context)) {
      for (const uint32_t triangle : pair) {
        const auto& corners = mesh->triangles[triangle];
        vertices.insert(vertices.end(), corners.begin(), corners.end());
      }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()),
                   vertices.end());
    // Those that are back at the start intersected there already; so pairs
    // without any other need not be looked at again.
    std::erase_if(vertices, [&](uint32_t v) {
      return steps[v] + 1u == kLeftOfWay.size() || target[v] == start[v];
    });
    if (vertices.empty()) {
      return num_withdrawn;
    }
    for (const uint32_t v : vertices) {
      num_withdrawn += steps[v] == 0 ? 1 : 0;
      mesh->positions[v] =
          start[v] + kLeftOfWay[++steps[v]] * (target[v] - start[v]);
    }
  }
}

// Rounds the vertices that have been moved back since `before`. Returns whether
// any is elsewhere now.
bool RoundWithdrawn(const std::vector<Eigen::Vector3d>& start,
                    const std::vector<Eigen::Vector3d>& before,
                    std::vector<Eigen::Vector3d>* positions) {
  bool is_changed = false;
  for (size_t v = 0; v < before.size(); ++v) {
    Eigen::Vector3d& position = (*positions)[v];
    const Eigen::Vector3d rounded = RoundedToFloats(position);
    if (position == before[v] || position == start[v] || position == rounded) {
      continue;
    }
    // Half of the last bit may be rounded up again and again.
    position = rounded == before[v] ? start[v] : rounded;
    is_changed = true;
  }
  return is_changed;
}

WithdrawSummary UntangleFrom(const std::vector<Eigen::Vector3d>& start,
                             double min_height,
                             const Context& context,
                             NewIntersections* intersections,
                             IndexedMesh* mesh) {
  WithdrawSummary summary;
  size_t num_intersecting;
  do {
    const WithdrawSummary thin = WithdrawFromThinTriangles(
        mesh->triangles, start, min_height, context, mesh->positions);
    num_intersecting =
        WithdrawFromIntersections(start, context, intersections, mesh);
    summary.num_withdrawn += thin.num_withdrawn + num_intersecting;
    summary.num_thin = thin.num_thin;
    // What is moved back may be thin again, until all of it is at the start.
  } while (num_intersecting > 0);
  return summary;
}

}  // namespace

void RoundToFloats(std::vector<Eigen::Vector3d>* positions) {
  for (Eigen::Vector3d& position : *positions) {
    position = RoundedToFloats(position);
  }
}

WithdrawSummary Untangle(const std::vector<Eigen::Vector3d>& start,
                         double min_height,
                         const Context& context,
                         IndexedMesh* mesh) {
  NewIntersections intersections(start);
  return UntangleFrom(start, min_height, context, &intersections, mesh);
}

WithdrawSummary UntangleFloats(const std::vector<Eigen::Vector3d>& start,
                               double min_height,
                               const Context& context,
                               IndexedMesh* mesh) {
  NewIntersections intersections(start);
  WithdrawSummary summary;
  std::vector<Eigen::Vector3d> before;
  do {
    before = mesh->positions;
    const WithdrawSummary once =
        UntangleFrom(start, min_height, context, &intersections, mesh);
    summary.num_withdrawn += once.num_withdrawn;
    summary.num_thin = once.num_thin;
  } while (RoundWithdrawn(start, before, &mesh->positions));
  return summary;
}

}  // namespace octacut
