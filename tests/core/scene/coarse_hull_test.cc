#include "core/scene/coarse_hull.h"

#include <gtest/gtest.h>

#include "tests/core/scene/synthetic_views.h"

namespace octacut {
namespace {

std::vector<SilhouettePyramid> SphereSilhouettes() {
  std::vector<SilhouettePyramid> silhouettes;
  for (const View& view : testing::RenderAllAround(
           {0, 0, 0}, 4, 300, testing::Sphere({0, 0, 0}, 1))) {
    silhouettes.emplace_back(view);
  }
  return silhouettes;
}

const Eigen::AlignedBox3d kBox(Eigen::Vector3d(-1.5, -2, -1.5),
                               Eigen::Vector3d(1.5, 1.5, 2.5));

// Refinement with early decisions gives what testing every cell gives.
TEST(CoarseHull, EqualsTestingEveryCell) {
  const std::vector<SilhouettePyramid> silhouettes = SphereSilhouettes();
  const CoarseHull hull = CarveBox(silhouettes, kBox, 4, Context(2));
  size_t inside = 0;
  for (int z = 0; z < 16; ++z) {
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        bool expected = true;
        for (const SilhouettePyramid& silhouette : silhouettes) {
          expected = expected && silhouette.Classify(hull.CellBox({x, y, z})) !=
                                     BoxVerdict::kBackground;
        }
        EXPECT_EQ(hull.inside[hull.CellNumber({x, y, z})] != 0, expected);
        inside += expected;
      }
    }
  }
  EXPECT_GT(inside, 100u);
}

TEST(CoarseHull, IsTheSameForAnyNumberOfThreads) {
  const std::vector<SilhouettePyramid> silhouettes = SphereSilhouettes();
  const CoarseHull one = CarveBox(silhouettes, kBox, 6, Context(1));
  const CoarseHull four = CarveBox(silhouettes, kBox, 6, Context(4));
  EXPECT_EQ(one.inside, four.inside);
}

TEST(CoarseHull, BoundingBoxLeavesSmallPiecesOut) {
  CoarseHull hull;
  hull.box = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(8, 16, 8)};
  hull.resolution = 8;
  hull.inside.assign(512, 0);
  for (int z = 2; z < 6; ++z) {
    for (int y = 2; y < 5; ++y) {
      for (int x = 1; x < 4; ++x) {
        hull.inside[hull.CellNumber({x, y, z})] = 1;
      }
    }
  }
  hull.inside[hull.CellNumber({4, 5, 6})] = 1;  // joined at a corner
  hull.inside[hull.CellNumber({7, 7, 7})] = 1;  // a piece of its own
  const Eigen::AlignedBox3d all = BoundingBoxOfPieces(hull, 0);
  EXPECT_TRUE(all.min().isApprox(Eigen::Vector3d(1, 4, 2)));
  EXPECT_TRUE(all.max().isApprox(Eigen::Vector3d(8, 16, 8)));
  const Eigen::AlignedBox3d large = BoundingBoxOfPieces(hull, 0.1);
  EXPECT_TRUE(large.min().isApprox(Eigen::Vector3d(1, 4, 2)));
  EXPECT_TRUE(large.max().isApprox(Eigen::Vector3d(5, 12, 7)));
  hull.inside.assign(512, 0);
  EXPECT_TRUE(BoundingBoxOfPieces(hull, 0).isEmpty());
}

}  // namespace
}  // namespace octacut
