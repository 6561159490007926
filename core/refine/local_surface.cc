#include "core/refine/local_surface.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 4096;
// More would be a mesh much finer than the radius: the nearest ones will do.
constexpr size_t kMaxNeighbors = 1024;
constexpr size_t kMinNeighbors = 8;
// Least cosine between the normals of a vertex and of what counts as the same
// side of the surface.
constexpr float kMinCosine = 0.3f;
// Weights fall to exp(-1 / (2 * 0.5^2)) at the radius.
constexpr double kSigma = 0.5;
// Pulls curvatures to zero that the vertices leave open.
constexpr double kRidge = 1e-3;

// The vertices within the radius of a vertex, found along the edges of the
// mesh, the nearest in edges first.
class Neighborhood {
 public:
  Neighborhood(const IndexedMesh& mesh, const VertexCorners& neighbors)
      : mesh_(mesh),
        neighbors_(neighbors),
        found_by_(mesh.positions.size(), kNone) {}

  const std::vector<uint32_t>& Gather(uint32_t vertex, double radius) {
    found_.assign(1, vertex);
    found_by_[vertex] = vertex;
    for (size_t i = 0; i < found_.size(); ++i) {
      for (const uint32_t next : neighbors_.Of(found_[i])) {
        if (found_.size() >= kMaxNeighbors) {
          return found_;
        }
        if (found_by_[next] != vertex && IsNear(vertex, next, radius)) {
          found_by_[next] = vertex;
          found_.push_back(next);
        }
      }
    }
    return found_;
  }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  bool IsNear(uint32_t vertex, uint32_t other, double radius) const {
    return (mesh_.positions[other] - mesh_.positions[vertex]).squaredNorm() <=
               radius * radius &&
           mesh_.normals[other].dot(mesh_.normals[vertex]) >= kMinCosine;
  }

  const IndexedMesh& mesh_;
  const VertexCorners& neighbors_;
  std::vector<uint32_t> found_by_;
  std::vector<uint32_t> found_;
};

LocalSurface TangentPlane(const Eigen::Vector3d& position,
                          const Eigen::Vector3d& normal) {
  LocalSurface plane;
  plane.center = position.cast<float>();
  plane.normal = normal.cast<float>();
  int axis;
  plane.normal.cwiseAbs().minCoeff(&axis);
  plane.tangent_u =
      plane.normal.cross(Eigen::Vector3f::Unit(axis)).normalized();
  return plane;
}

double Weight(const Eigen::Vector3d& offset, double radius) {
  const double scaled = 1 / (kSigma * radius);
  return std::exp(-0.5 * offset.squaredNorm() * scaled * scaled);
}

Eigen::Vector3d MeanNormal(const IndexedMesh& mesh,
                           const std::vector<uint32_t>& vertices,
                           double radius) {
  const Eigen::Vector3d& middle = mesh.positions[vertices[0]];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const uint32_t vertex : vertices) {
    sum += Weight(mesh.positions[vertex] - middle, radius) *
           mesh.normals[vertex].cast<double>();
  }
  return sum.normalized();  // all are within a cone: never zero
}

// z = a + b x + c y + d x^2 + e x y + f y^2 in the frame of the mean normal,
// lengths in units of the radius.
LocalSurface Fit(const IndexedMesh& mesh,
                 const std::vector<uint32_t>& vertices,
                 double radius) {
  const Eigen::Vector3d middle = mesh.positions[vertices[0]];
  LocalSurface surface =
      TangentPlane(middle, MeanNormal(mesh, vertices, radius));
  if (vertices.size() < kMinNeighbors) {
    return surface;
  }
  Eigen::Matrix3d axes;
  axes.row(0) = surface.tangent_u.cast<double>();
  axes.row(1) = surface.TangentV().cast<double>();
  axes.row(2) = surface.normal.cast<double>();
  axes /= radius;
  using Vector6d = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> products = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6d right = Vector6d::Zero();
  for (const uint32_t vertex : vertices) {
    const Eigen::Vector3d offset = mesh.positions[vertex] - middle;
    const double weight = Weight(offset, radius);
    const Eigen::Vector3d p = axes * offset;
    Vector6d row;
    row << 1, p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
    products.noalias() += weight * row * row.transpose();
    right += weight * p.z() * row;
  }
  products.diagonal().tail<3>().array() += kRidge;
  products.diagonal().array() += 1e-9;
  const Vector6d s = products.ldlt().solve(right);
  const Eigen::Vector3d mean_normal = surface.normal.cast<double>();
  const Eigen::Vector3d normal =
      (mean_normal - s[1] * surface.tangent_u.cast<double>() -
       s[2] * surface.TangentV().cast<double>())
          .normalized();
  // The curvatures hold over the mean normal's plane; the fitted normal is
  // close to it.
  surface.center += (s[0] * radius * mean_normal).cast<float>();
  surface.height = float(s[0] * radius * mean_normal.dot(normal));
  surface.normal = normal.cast<float>();
  surface.tangent_u = (surface.tangent_u -
                       surface.tangent_u.dot(surface.normal) * surface.normal)
                          .normalized();
  surface.uu = float(s[3] / radius);
  surface.uv = float(s[4] / radius);
  surface.vv = float(s[5] / radius);
  return surface;
}

}  // namespace

std::vector<LocalSurface> FitLocalSurfaces(
    const IndexedMesh& mesh,
    const VertexCorners& neighbors,
    const std::vector<uint32_t>& vertices,
    double radius,
    const Context& context) {
  std::vector<LocalSurface> surfaces(vertices.size());
  ParallelFor(context, surfaces.size(), kGrain, [&](size_t begin, size_t end) {
    Neighborhood neighborhood(mesh, neighbors);
    for (size_t i = begin; i < end; ++i) {
      surfaces[i] = Fit(mesh, neighborhood.Gather(vertices[i], radius), radius);
    }
  });
  return surfaces;
}

}  // namespace octacut
