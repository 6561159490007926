#include "core/refine/spread_vertices.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

TEST(SpreadVertices, AreApartAndCoverTheMesh) {
  const IndexedMesh mesh = Sphere(16, 1);
  const double distance = 0.2;
  const std::vector<uint8_t> all(mesh.positions.size(), 1);
  const std::vector<uint32_t> chosen = SpreadVertices(
      mesh, testing::RefineScene::Neighbors(mesh), all, distance);
  EXPECT_LT(chosen.size(), mesh.positions.size() / 3);
  const auto between = [&](uint32_t a, uint32_t b) {
    return (mesh.positions[a] - mesh.positions[b]).norm();
  };
  for (uint32_t v = 0; v < mesh.positions.size(); ++v) {
    double nearest = 10;
    for (const uint32_t c : chosen) {
      nearest = std::min(nearest, c == v ? 10 : between(c, v));
    }
    if (std::binary_search(chosen.begin(), chosen.end(), v)) {
      EXPECT_GT(nearest, distance);
    } else {
      EXPECT_LE(nearest, distance);
    }
  }
}

TEST(SpreadVertices, TakesOnlyEligibleOnesAndAllAtDistanceZero) {
  const IndexedMesh mesh = Sphere(6, 1);
  std::vector<uint8_t> eligible(mesh.positions.size());
  std::vector<uint32_t> expected;
  for (uint32_t v = 0; v < eligible.size(); v += 3) {
    eligible[v] = 1;
    expected.push_back(v);
  }
  EXPECT_EQ(
      SpreadVertices(mesh, testing::RefineScene::Neighbors(mesh), eligible, 0),
      expected);
}

}  // namespace
}  // namespace octacut
