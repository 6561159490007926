#include "core/refine/surface_points.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace octacut {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

// Points with the vertices that are closest to them.
void Spread(const IndexedMesh& mesh,
            const VertexCorners& neighbors,
            double distance,
            SurfacePoints* points) {
  const size_t count = mesh.positions.size();
  std::vector<double> closest(count, std::numeric_limits<double>::infinity());
  std::vector<uint32_t> found_by(count, kNone);
  std::vector<uint32_t> found;
  points->point_of.assign(count, kNone);
  for (uint32_t vertex = 0; vertex < count; ++vertex) {
    if (points->point_of[vertex] != kNone) {
      continue;
    }
    const uint32_t point = uint32_t(points->vertices.size());
    points->vertices.push_back(vertex);
    found.assign(1, vertex);
    found_by[vertex] = vertex;
    for (size_t i = 0; i < found.size(); ++i) {
      const double squared =
          (mesh.positions[found[i]] - mesh.positions[vertex]).squaredNorm();
      if (i > 0 && squared > distance * distance) {
        continue;
      }
      if (squared < closest[found[i]]) {
        closest[found[i]] = squared;
        points->point_of[found[i]] = point;
      }
      for (const uint32_t next : neighbors.Of(found[i])) {
        if (found_by[next] != vertex) {
          found_by[next] = vertex;
          found.push_back(next);
        }
      }
    }
  }
}

VertexCorners JoinPoints(const VertexCorners& neighbors,
                         const std::vector<uint32_t>& point_of,
                         size_t num_points) {
  std::vector<std::pair<uint32_t, uint32_t>> joints;
  for (size_t v = 0; v < point_of.size(); ++v) {
    for (const uint32_t next : neighbors.Of(v)) {
      if (point_of[v] != point_of[next]) {
        joints.emplace_back(point_of[v], point_of[next]);
      }
    }
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  VertexCorners result;
  result.offsets.assign(num_points + 1, 0);
  for (const auto& [from, to] : joints) {
    ++result.offsets[from + 1];
    result.entries.push_back(to);
  }
  for (size_t point = 0; point < num_points; ++point) {
    result.offsets[point + 1] += result.offsets[point];
  }
  return result;
}

}  // namespace

SurfacePoints SpreadPoints(const IndexedMesh& mesh,
                           const VertexCorners& neighbors,
                           double distance) {
  SurfacePoints points;
  Spread(mesh, neighbors, distance, &points);
  points.neighbors =
      JoinPoints(neighbors, points.point_of, points.vertices.size());
  return points;
}

}  // namespace octacut
