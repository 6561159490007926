#include "core/refine/local_surface.h"

#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "core/base/parallel.h"
#include "core/refine/thinned_surface.h"

namespace octacut {
namespace {

constexpr size_t kSurfaceGrain = 4096;
// Samples per radius where a mesh is much finer than the radius.
constexpr double kSamplesPerRadius = 12;
constexpr size_t kMinNeighbors = 8;
// Least cosine between the normals of a vertex and of what counts as the same
// side of the surface.
constexpr float kMinCosineOfNeighbors = 0.3f;
// Weights fall to exp(-1 / (2 * 0.5^2)) at the radius.
constexpr double kSigma = 0.5;
// Pulls curvatures to zero that the vertices leave open.
constexpr double kQuadricRidge = 1e-3;

// The samples within the radius of a point, found from one next to it along
// their joints.
class Neighborhood {
 public:
  explicit Neighborhood(const ThinnedSurface& samples)
      : samples_(samples), found_by_(samples.Positions().size(), kNone) {}

  // `vertex` is another one in every call.
  const std::vector<uint32_t>& Gather(uint32_t vertex,
                                      const Eigen::Vector3d& position,
                                      const Eigen::Vector3f& normal,
                                      double radius) {
    const uint32_t first = samples_.Of(vertex);
    found_.assign(1, first);
    found_by_[first] = vertex;
    for (size_t i = 0; i < found_.size(); ++i) {
      for (const uint32_t next : samples_.Neighbors(found_[i])) {
        if (found_by_[next] != vertex &&
            IsNear(next, position, normal, radius)) {
          found_by_[next] = vertex;
          found_.push_back(next);
        }
      }
    }
    return found_;
  }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  bool IsNear(uint32_t sample,
              const Eigen::Vector3d& position,
              const Eigen::Vector3f& normal,
              double radius) const {
    return (samples_.Positions()[sample] - position).squaredNorm() <=
               radius * radius &&
           samples_.Normals()[sample].dot(normal) >= kMinCosineOfNeighbors;
  }

  const ThinnedSurface& samples_;
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

// By their distance from the middle.
void Weigh(const ThinnedSurface& samples,
           const std::vector<uint32_t>& near,
           const Eigen::Vector3d& middle,
           double radius,
           std::vector<double>* weights) {
  const double scaled = 1 / (kSigma * radius);
  weights->clear();
  for (const uint32_t sample : near) {
    const double square = (samples.Positions()[sample] - middle).squaredNorm();
    weights->push_back(std::exp(-0.5 * square * scaled * scaled));
  }
}

// The mean normal of what is near a vertex with this normal.
Eigen::Vector3d MeanNormal(const ThinnedSurface& samples,
                           const std::vector<uint32_t>& near,
                           const std::vector<double>& weights,
                           const Eigen::Vector3f& normal) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < near.size(); ++i) {
    sum += weights[i] * samples.Normals()[near[i]].cast<double>();
  }
  // All are within a cone but for the first one, which stands for the vertex.
  const Eigen::Vector3d own = normal.cast<double>();
  return sum.dot(own) > 0 ? sum.normalized() : own;
}

// z = a + b x + c y + d x^2 + e x y + f y^2 over `middle`, in the frame of the
// mean normal, lengths in units of the radius.
LocalSurface Fit(const ThinnedSurface& samples,
                 const std::vector<uint32_t>& near,
                 const std::vector<double>& weights,
                 const Eigen::Vector3d& middle,
                 const Eigen::Vector3f& vertex_normal,
                 double radius) {
  LocalSurface surface =
      TangentPlane(middle, MeanNormal(samples, near, weights, vertex_normal));
  if (near.size() < kMinNeighbors) {
    return surface;
  }
  Eigen::Matrix3d axes;
  axes.row(0) = surface.tangent_u.cast<double>();
  axes.row(1) = surface.TangentV().cast<double>();
  axes.row(2) = surface.normal.cast<double>();
  axes /= radius;
  using Coefficients = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> products = Eigen::Matrix<double, 6, 6>::Zero();
  Coefficients right = Coefficients::Zero();
  for (size_t n = 0; n < near.size(); ++n) {
    const Eigen::Vector3d p = axes * (samples.Positions()[near[n]] - middle);
    Coefficients row;
    row << 1, p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
    // The lower triangle, which is all that the decomposition reads.
    for (int i = 0; i < 6; ++i) {
      const double weighted = weights[n] * row[i];
      for (int j = 0; j <= i; ++j) {
        products(i, j) += weighted * row[j];
      }
      right[i] += weighted * p.z();
    }
  }
  products.diagonal().tail<3>().array() += kQuadricRidge;
  products.diagonal().array() += 1e-9;
  const Coefficients s = products.ldlt().solve(right);
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
  const ThinnedSurface samples(mesh, neighbors, radius / kSamplesPerRadius);
  std::vector<LocalSurface> surfaces(vertices.size());
  ParallelFor(
      context, surfaces.size(), kSurfaceGrain, [&](size_t begin, size_t end) {
        Neighborhood neighborhood(samples);
        std::vector<double> weights;
        for (size_t i = begin; i < end; ++i) {
          const uint32_t vertex = vertices[i];
          const Eigen::Vector3d& position = mesh.positions[vertex];
          const Eigen::Vector3f& normal = mesh.normals[vertex];
          const std::vector<uint32_t>& near =
              neighborhood.Gather(vertex, position, normal, radius);
          Weigh(samples, near, position, radius, &weights);
          surfaces[i] = Fit(samples, near, weights, position, normal, radius);
        }
      });
  return surfaces;
}

}  // namespace octacut
