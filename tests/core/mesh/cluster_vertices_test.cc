#include "core/mesh/cluster_vertices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/mesh/remarkable_places.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

TEST(ClusterVertices, AFlatFieldStaysFlatWithItsBorders) {
  const IndexedMesh field =
      HeightField(60, [](double x, double y) { return 0.3 * x + 0.1 * y; });
  const ClusteredMesh coarse = ClusterVertices(field, 500, Context(2));
  EXPECT_TRUE(coarse.is_simplified);
  EXPECT_LE(coarse.mesh.triangles.size(), 500u);
  // The finest grid that fits.
  EXPECT_GT(coarse.mesh.triangles.size(), 300u);
  ASSERT_EQ(coarse.sources.size(), coarse.mesh.positions.size());
  for (size_t i = 0; i < coarse.sources.size(); ++i) {
    const Eigen::Vector3d& p = coarse.mesh.positions[i];
    EXPECT_NEAR(p.z(), 0.3 * p.x() + 0.1 * p.y(), 1e-12);
    // A vertex of its own cell.
    EXPECT_LT((field.positions[coarse.sources[i]] - p).norm(), 0.1);
  }
}

TEST(ClusterVertices, QuadricsKeepCorners) {
  const IndexedMesh cube = Cube(40);
  const ClusteredMesh coarse = ClusterVertices(cube, 1000, Context(2));
  // Means of vertices would round the corners off by a third of a cell, which
  // is 0.08 or more.
  for (const Eigen::Vector3d& corner :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)}) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& p : coarse.mesh.positions) {
      nearest = std::min(nearest, (p - corner).norm());
    }
    EXPECT_LT(nearest, 1e-6);
  }
}

TEST(ClusterVertices, SmallMeshesComeBackWithoutUnusedVertices) {
  IndexedMesh cube = Cube(2);
  cube.positions.insert(cube.positions.begin(), Eigen::Vector3d(9, 9, 9));
  for (auto& triangle : cube.triangles) {
    for (uint32_t& corner : triangle) {
      ++corner;
    }
  }
  const ClusteredMesh same = ClusterVertices(cube, 1000, Context(2));
  EXPECT_FALSE(same.is_simplified);
  EXPECT_EQ(same.mesh.triangles.size(), cube.triangles.size());
  EXPECT_EQ(same.mesh.positions.size(), cube.positions.size() - 1);
  for (size_t i = 0; i < same.sources.size(); ++i) {
    EXPECT_EQ(same.mesh.positions[i], cube.positions[same.sources[i]]);
  }
}

TEST(ClusterVertices, RefusesWhatIsNoMesh) {
  EXPECT_THROW(ClusterVertices({}, 100, Context(2)), InputError);
  IndexedMesh cube = Cube(1);
  cube.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ClusterVertices(cube, 100, Context(2)), InputError);
}

TEST(ClusterVertices, TrianglesWithoutCommonVerticesAreWelded) {
  const IndexedMesh field =
      HeightField(20, [](double x, double y) { return x * y; });
  IndexedMesh soup;
  for (const auto& triangle : field.triangles) {
    const auto first = uint32_t(soup.positions.size());
    for (const uint32_t corner : triangle) {
      soup.positions.push_back(field.positions[corner]);
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const ClusteredMesh welded =
      ClusterVertices(soup, soup.triangles.size(), Context(1));
  EXPECT_EQ(welded.mesh.triangles.size(), field.triangles.size());
  EXPECT_EQ(welded.mesh.positions.size(), field.positions.size());
  // Apart from each other, they cannot be: fewer are shown.
  for (size_t i = 0; i < soup.positions.size(); ++i) {
    soup.positions[i].z() += double(i / 3);
  }
  EXPECT_LE(ClusterVertices(soup, soup.triangles.size(), Context(1))
                .mesh.positions.size(),
            soup.triangles.size());
}

TEST(FindRemarkablePlaces, LargestFirstAndApart) {
  const IndexedMesh field = HeightField(10, [](double, double) { return 0; });
  std::vector<float> values(field.positions.size(),
                            std::numeric_limits<float>::quiet_NaN());
  values[0] = 5;    // (0, 0)
  values[1] = 4;    // (0.1, 0): too near
  values[3] = 3;    // (0.3, 0)
  values[120] = 6;  // (1, 1)
  const std::vector<Eigen::Vector3f> normals(values.size(),
                                             Eigen::Vector3f::UnitZ());
  const auto places = FindRemarkablePlaces(field, values, normals, 10, 0.2);
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0].vertex, 120u);
  EXPECT_EQ(places[1].vertex, 0u);
  EXPECT_EQ(places[2].vertex, 3u);
  EXPECT_EQ(FindRemarkablePlaces(field, values, normals, 1, 0.2).size(), 1u);
}

TEST(CellMeans, NeedEnoughValues) {
  IndexedMesh points;
  points.positions = {{0.1, 0.1, 0.1}, {0.2, 0.1, 0.1}, {5, 5, 5}};
  const std::vector<float> means = CellMeans(points, {1, 3, 9}, 1, 2);
  EXPECT_EQ(means[0], 2);
  EXPECT_EQ(means[1], 2);
  EXPECT_TRUE(std::isnan(means[2]));
}

}  // namespace
}  // namespace octacut
