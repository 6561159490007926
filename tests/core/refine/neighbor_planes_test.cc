#include "core/refine/neighbor_planes.h"

#include <gtest/gtest.h>

#include "core/refine/surface_points.h"
#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::RefineScene;

TEST(NeighborPlanes, ContinueWhatTiltsEvenly) {
  const IndexedMesh mesh = [] {
    IndexedMesh sphere = Sphere(40, 1);
    sphere.normals = ComputeVertexNormals(sphere, Context(1));
    return sphere;
  }();
  const VertexCorners neighbors = RefineScene::Neighbors(mesh);
  const SurfacePoints points = SpreadPoints(mesh, neighbors, 0.08);
  const std::vector<LocalSurface> surfaces =
      FitLocalSurfaces(mesh, neighbors, points.vertices, 0.1, Context(1));
  const NeighborPlanes planes = FitNeighborPlanes(surfaces, points.neighbors);
  ASSERT_EQ(planes.shares.size(), points.neighbors.entries.size());
  ASSERT_EQ(planes.spacings.size(), surfaces.size());
  const Eigen::Vector3f tilt(0.3f, -0.5f, 0.2f);
  std::vector<double> values;
  values.reserve(surfaces.size());
  for (const LocalSurface& surface : surfaces) {
    values.push_back(tilt.dot(surface.center));
  }
  const std::vector<Eigen::Vector3f> slopes =
      planes.Slopes(values, points.neighbors);
  for (size_t i = 0; i < surfaces.size(); ++i) {
    const auto around = points.neighbors.Of(i);
    double sum = 0, value = 0;
    for (size_t k = 0; k < around.size(); ++k) {
      const float share = planes.shares[points.neighbors.offsets[i] + k];
      sum += share;
      value += share * values[around[k]];
    }
    EXPECT_NEAR(sum, 1, 1e-4);
    // A sphere bends away from the plane by half of the squared distance.
    EXPECT_NEAR(value, values[i], 0.01);
    const Eigen::Vector3f& normal = surfaces[i].normal;
    EXPECT_LT((slopes[i] - (tilt - tilt.dot(normal) * normal)).norm(), 0.1);
    EXPECT_GT(planes.spacings[i], 0.08);
    EXPECT_LT(planes.spacings[i], 0.2);
  }
}

// Of surfaces that are at most so far apart.
VertexCorners NeighborsWithin(float radius,
                              const std::vector<LocalSurface>& surfaces) {
  VertexCorners neighbors;
  neighbors.offsets = {0};
  for (const LocalSurface& surface : surfaces) {
    for (size_t k = 0; k < surfaces.size(); ++k) {
      const float distance = (surfaces[k].center - surface.center).norm();
      if (distance > 0 && distance <= radius) {
        neighbors.entries.push_back(uint32_t(k));
      }
    }
    neighbors.offsets.push_back(uint32_t(neighbors.entries.size()));
  }
  return neighbors;
}

// On two faces of a box, one of which moves, points do not follow their
// neighbours across the edge.
TEST(NeighborPlanes, EndAtEdges) {
  std::vector<LocalSurface> surfaces;
  std::vector<double> values;
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) {
      const float y = float(row);
      const float way = float(column) + 0.5f;  // to the edge
      LocalSurface surface;
      surface.tangent_u = Eigen::Vector3f::UnitY();
      surface.center = {-way, y, 0};
      surface.normal = Eigen::Vector3f::UnitZ();
      surfaces.push_back(surface);
      values.push_back(1);
      surface.center = {0, y, -way};
      surface.normal = Eigen::Vector3f::UnitX();
      surfaces.push_back(surface);
      values.push_back(0);
    }
  }
  const VertexCorners neighbors = NeighborsWithin(1.5f, surfaces);
  const NeighborPlanes planes = FitNeighborPlanes(surfaces, neighbors);
  const std::vector<Eigen::Vector3f> slopes = planes.Slopes(values, neighbors);
  for (size_t i = 0; i < surfaces.size(); ++i) {
    const auto around = neighbors.Of(i);
    double value = 0;
    for (size_t k = 0; k < around.size(); ++k) {
      value += planes.shares[neighbors.offsets[i] + k] * values[around[k]];
    }
    EXPECT_NEAR(value, values[i], 0.02);
    EXPECT_LT(slopes[i].norm(), 0.02);
  }
}

}  // namespace
}  // namespace octacut
