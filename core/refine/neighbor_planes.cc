#include "core/refine/neighbor_planes.h"

#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace octacut {
namespace {

// Keeps planes flat that too few neighbours leave open, share of the mean
// square.
constexpr float kPlaneRidge = 1e-2f;

}  // namespace

NeighborPlanes FitNeighborPlanes(const std::vector<LocalSurface>& surfaces,
                                 const VertexCorners& neighbors) {
  NeighborPlanes planes;
  planes.shares.reserve(neighbors.corners.size());
  planes.slopes.reserve(neighbors.corners.size());
  planes.spacings.reserve(surfaces.size());
  std::vector<Eigen::Vector3f> rows;  // 1, x, y; lengths in mean distances
  for (size_t i = 0; i < surfaces.size(); ++i) {
    const LocalSurface& surface = surfaces[i];
    const std::span<const uint32_t> around = neighbors.Of(i);
    float squares = 0;
    for (const uint32_t next : around) {
      squares += (surfaces[next].center - surface.center).squaredNorm();
    }
    const float spacing = std::sqrt(squares / float(around.size()));
    planes.spacings.push_back(around.empty() ? 0 : spacing);
    const Eigen::Vector3f tangent_v = surface.TangentV();
    rows.clear();
    Eigen::Matrix3f products = Eigen::Matrix3f::Zero();
    for (const uint32_t next : around) {
      const Eigen::Vector3f offset =
          (surfaces[next].center - surface.center) / spacing;
      rows.emplace_back(
          1, offset.dot(surface.tangent_u), offset.dot(tangent_v));
      products += rows.back() * rows.back().transpose();
    }
    products.diagonal().tail<2>().array() += kPlaneRidge * float(around.size());
    const Eigen::LDLT<Eigen::Matrix3f> solver(products);
    for (const Eigen::Vector3f& row : rows) {
      const Eigen::Vector3f plane = solver.solve(row);
      planes.shares.push_back(plane[0]);
      planes.slopes.push_back(
          (plane[1] * surface.tangent_u + plane[2] * tangent_v) / spacing);
    }
  }
  return planes;
}

std::vector<Eigen::Vector3f> NeighborPlanes::Slopes(
    const std::vector<double>& values, const VertexCorners& neighbors) const {
  std::vector<Eigen::Vector3f> sums(values.size(), Eigen::Vector3f::Zero());
  for (size_t i = 0; i < sums.size(); ++i) {
    for (uint32_t k = neighbors.offsets[i]; k < neighbors.offsets[i + 1]; ++k) {
      sums[i] += float(values[neighbors.corners[k]]) * slopes[k];
    }
  }
  return sums;
}

}  // namespace octacut
