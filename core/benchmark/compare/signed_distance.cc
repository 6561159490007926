#include "core/benchmark/compare/signed_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <span>

#include "core/base/parallel.h"
#include "core/mesh/cloud.h"
#include "core/mesh/normals.h"
#include "core/mesh/triangle_normal.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {
namespace {

constexpr size_t kVertexGrain = 2048;
// Below this barycentric coordinate, a point is on the opposite edge.
constexpr double kOnEdge = 1e-9;

class Sides {
 public:
  Sides(const IndexedMesh& surface, const Context& context)
      : surface_(surface),
        is_cloud_(IsCloud(surface)),
        vertex_normals_(ComputeVertexNormals(surface, context)),
        corners_(
            FindVertexCorners(surface.positions.size(), surface.triangles)) {}

  double SignAt(const RayScene::Closest& closest,
                const Eigen::Vector3d& point) const {
    if (is_cloud_) {
      return 1;
    }
    const Eigen::Vector3d normal = PseudoNormal(closest);
    return normal.dot(point - closest.point) < 0 ? -1 : 1;
  }

 private:
  Eigen::Vector3d FaceNormal(uint32_t triangle) const {
    return AreaNormal(surface_, surface_.triangles[triangle])
        .stableNormalized();
  }

  // Sum of the normals of the triangles that have both vertices.
  Eigen::Vector3d EdgeNormal(uint32_t a, uint32_t b) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const uint32_t corner : corners_.Of(a)) {
      const std::array<uint32_t, 3>& triangle = surface_.triangles[corner / 3];
      if (std::find(triangle.begin(), triangle.end(), b) != triangle.end()) {
        sum += FaceNormal(corner / 3);
      }
    }
    return sum;
  }

  Eigen::Vector3d PseudoNormal(const RayScene::Closest& closest) const {
    const std::array<uint32_t, 3>& triangle =
        surface_.triangles[closest.triangle];
    const Eigen::Vector3d& a = surface_.positions[triangle[0]];
    const Eigen::Vector3d& b = surface_.positions[triangle[1]];
    const Eigen::Vector3d& c = surface_.positions[triangle[2]];
    Eigen::Vector3d normal = AreaNormal(surface_, triangle);
    const double area = normal.squaredNorm();
    if (!(area > 0)) {
      return vertex_normals_[triangle[0]].cast<double>();
    }
    const Eigen::Vector3d& p = closest.point;
    const std::array<double, 3> weights = {
        normal.dot((b - p).cross(c - p)) / area,
        normal.dot((c - p).cross(a - p)) / area,
        normal.dot((a - p).cross(b - p)) / area};
    const auto is_zero = [&](int i) { return weights[size_t(i)] <= kOnEdge; };
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3;
      const int last = (i + 2) % 3;
      if (is_zero(next) && is_zero(last)) {
        return vertex_normals_[triangle[size_t(i)]].cast<double>();
      }
      if (is_zero(i) && !is_zero(next) && !is_zero(last)) {
        return EdgeNormal(triangle[size_t(next)], triangle[size_t(last)]);
      }
    }
    return normal;
  }

  const IndexedMesh& surface_;
  bool is_cloud_;
  std::vector<Eigen::Vector3f> vertex_normals_;
  VertexCorners corners_;
};

}  // namespace

std::vector<float> SignedDistances(const std::vector<Eigen::Vector3d>& points,
                                   const IndexedMesh& surface,
                                   const RayScene& rays,
                                   const Context& context,
                                   const ReferenceFilter& filter) {
  const Sides sides(surface, context);
  std::vector<float> distances(points.size());
  Phase phase(context, "signed distances", points.size());
  ParallelFor(
      context, points.size(), kVertexGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const RayScene::Closest closest = rays.ClosestPoint(points[i]);
          const bool counts =
              !filter || filter(closest.triangle, closest.point);
          distances[i] =
              counts ? static_cast<float>(sides.SignAt(closest, points[i]) *
                                          closest.distance)
                     : std::numeric_limits<float>::quiet_NaN();
        }
        phase.Advance(end - begin);
      });
  return distances;
}

void DropUnjudged(const IndexedMesh& reference,
                  const ReferenceFilter& filter,
                  std::vector<float>* values) {
  if (!filter) {
    return;
  }
  std::vector<bool> counts(values->size());
  for (uint32_t i = 0; i < reference.triangles.size(); ++i) {
    for (const uint32_t vertex : reference.triangles[i]) {
      if (!counts[vertex] && filter(i, reference.positions[vertex])) {
        counts[vertex] = true;
      }
    }
  }
  for (size_t i = 0; i < values->size(); ++i) {
    if (!counts[i]) {
      (*values)[i] = std::numeric_limits<float>::quiet_NaN();
    }
  }
}

}  // namespace octacut
