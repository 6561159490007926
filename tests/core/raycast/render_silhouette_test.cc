#include "core/raycast/render_silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/raycast/render.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

// A square of edge 2 at distance 4.
IndexedMesh SquareInFront() {
  IndexedMesh mesh;
  mesh.positions = {{-1, -1, 4}, {1, -1, 4}, {1, 1, 4}, {-1, 1, 4}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

cv::Mat RenderByPinhole(const RayScene& rays, const PinholeCamera& camera) {
  const Context context(2);
  return RenderSilhouette(
      rays, camera, {}, RenderDepth(rays, camera, {}, context), context);
}

TEST(RenderSilhouette, IsCoverageByAnyLens) {
  const RayScene rays(SquareInFront());
  // 2 / 4 * 41 = 20.5 pixels wide; the lens shows nothing in the first columns.
  const auto ray_of =
      [](const Eigen::Vector2d& pixel) -> std::optional<Eigen::Vector3d> {
    if (pixel.x() < 12) {
      return {};
    }
    return Eigen::Vector3d((pixel.x() - 20) / 41, (pixel.y() - 15) / 41, 1);
  };
  const cv::Mat mask =
      RenderSilhouette(rays, {40, 30}, ray_of, Rigid3d(), Context(2));
  ASSERT_EQ(mask.size(), cv::Size(40, 30));
  EXPECT_EQ(mask.at<uint8_t>(15, 11), 0);
  EXPECT_EQ(mask.at<uint8_t>(15, 12), 255);
  EXPECT_EQ(mask.at<uint8_t>(15, 29), 255);
  // The right border is at 30.25.
  EXPECT_NEAR(mask.at<uint8_t>(15, 30), 255 / 4, 1);
  EXPECT_EQ(mask.at<uint8_t>(15, 31), 0);
  EXPECT_NEAR(mask.at<uint8_t>(4, 20), 255 / 4, 1);  // begins at 4.75
}

TEST(RenderSilhouette, CoversWhatTheSquareCovers) {
  // 30 x 30 pixels around the centre, with borders on those of pixels.
  const cv::Mat mask =
      RenderByPinhole(RayScene(SquareInFront()), {64, 48, 60, 60, 32, 24});
  ASSERT_EQ(mask.type(), CV_8UC1);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const bool inside = x >= 17 && x < 47 && y >= 9 && y < 39;
      ASSERT_EQ(mask.at<uint8_t>(y, x), inside ? 255 : 0) << x << " " << y;
    }
  }
}

TEST(RenderSilhouette, BordersAreCoverage) {
  // 30.5 pixels wide: a quarter of each border pixel.
  const cv::Mat mask =
      RenderByPinhole(RayScene(SquareInFront()), {64, 48, 61, 61, 32, 24});
  EXPECT_EQ(mask.at<uint8_t>(24, 16), 64);
  EXPECT_EQ(mask.at<uint8_t>(24, 47), 64);
  EXPECT_EQ(mask.at<uint8_t>(8, 30), 64);
  EXPECT_EQ(mask.at<uint8_t>(8, 16), 16);
}

TEST(RenderSilhouette, OutlineIsWhatRaysThroughAllPixelsShow) {
  const RayScene rays(Moved(Sphere(48, 1.0), {0.1, -0.2, 4}));
  const PinholeCamera camera = {90, 70, 100, 100, 45, 35};
  const cv::Mat mask = RenderByPinhole(rays, camera);
  int num_partly = 0;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      int num_hits = 0;
      for (int k = 0; k < 16; ++k) {
        const int row = k / 4;
        num_hits += rays.IsOccluded(
            Eigen::Vector3d::Zero(),
            camera.Unproject({x + (k % 4 + 0.5) / 4, y + (row + 0.5) / 4}),
            0,
            std::numeric_limits<double>::infinity());
      }
      EXPECT_EQ(mask.at<uint8_t>(y, x), std::lround(255.0 * num_hits / 16));
      num_partly += num_hits > 0 && num_hits < 16;
    }
  }
  EXPECT_GT(num_partly, 100);
}

}  // namespace
}  // namespace octacut
