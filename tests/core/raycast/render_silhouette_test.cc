#include "core/raycast/render_silhouette.h"

#include <gtest/gtest.h>

#include <cmath>

namespace octacut {
namespace {

// A square of edge 2 at distance 4.
IndexedMesh Square() {
  IndexedMesh mesh;
  mesh.positions = {{-1, -1, 4}, {1, -1, 4}, {1, 1, 4}, {-1, 1, 4}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(RenderSilhouette, IsCoverageByAnyLens) {
  const RayScene rays(Square());
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

}  // namespace
}  // namespace octacut
