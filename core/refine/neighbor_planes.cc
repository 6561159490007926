#include "core/refine/neighbor_planes.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <span>

namespace octacut {
namespace {

// Keeps planes flat that too few neighbours leave open, share of the mean
// square.
constexpr float kPlaneRidge = 1e-2f;
// Standard deviation of the difference between the normals of neighbours on one
// face. Neighbours are two pixels of the round apart, and pieces are fitted
// with a radius of nine: at a rectangular edge, normals turn by 0.17 on that
// way. For other values see docs/experiments/refinement_edges.md.
constexpr float kFaceDeviation = 0.15f;
// Of a neighbour, however much its normal differs: a point alone on its face
// still has a plane.
constexpr float kLeastWeight = 1e-3f;

// One for each neighbour, 1 on average.
std::vector<float> WeighNeighbors(const std::vector<LocalSurface>& surfaces,
                                  const LocalSurface& surface,
                                  std::span<const uint32_t> around) {
  std::vector<float> weights;
  weights.reserve(around.size());
  float sum = 0;
  for (const uint32_t next : around) {
    const float squared =
        (surfaces[next].normal - surface.normal).squaredNorm() /
        (kFaceDeviation * kFaceDeviation);
    weights.push_back(std::max(std::exp(-0.5f * squared), kLeastWeight));
    sum += weights.back();
  }
  for (float& weight : weights) {
    weight *= float(weights.size()) / sum;
  }
  return weights;
}

}  // namespace

NeighborPlanes FitNeighborPlanes(const std::vector<LocalSurface>& surfaces,
                                 const VertexCorners& neighbors) {
  NeighborPlanes planes;
  planes.shares.reserve(neighbors.entries.size());
  planes.slopes.reserve(neighbors.entries.size());
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
    const std::vector<float> weights =
        WeighNeighbors(surfaces, surface, around);
    rows.clear();
    Eigen::Matrix3f products = Eigen::Matrix3f::Zero();
    for (size_t k = 0; k < around.size(); ++k) {
      const Eigen::Vector3f offset =
          (surfaces[around[k]].center - surface.center) / spacing;
      rows.emplace_back(
          1, offset.dot(surface.tangent_u), offset.dot(tangent_v));
      products += weights[k] * rows.back() * rows.back().transpose();
    }
    products.diagonal().tail<2>().array() += kPlaneRidge * float(around.size());
    const Eigen::LDLT<Eigen::Matrix3f> solver(products);
    for (size_t k = 0; k < rows.size(); ++k) {
      const Eigen::Vector3f plane = weights[k] * solver.solve(rows[k]);
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
      sums[i] += float(values[neighbors.entries[k]]) * slopes[k];
    }
  }
  return sums;
}

}  // namespace octacut
