#include "core/raycast/render_coverage.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/raycast/render.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

TEST(RenderCoverage, IsTheMaskOfAllRays) {
  const IndexedMesh sphere = Moved(Sphere(48, 1.0), {0.1, -0.2, 4});
  const RayScene rays(sphere);
  const PinholeCamera camera = {90, 70, 100, 100, 45, 35};
  const Context context(2);
  const cv::Mat depth = RenderDepth(rays, camera, {}, context);
  const cv::Mat coverage = RenderCoverage(rays, camera, {}, depth, context);
  const cv::Mat mask = RenderMask(rays, camera, {}, context);
  ASSERT_EQ(coverage.size(), mask.size());
  int num_partly = 0;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      EXPECT_EQ(coverage.at<uint8_t>(y, x), mask.at<uint8_t>(y, x));
      num_partly += mask.at<uint8_t>(y, x) > 0 && mask.at<uint8_t>(y, x) < 255;
    }
  }
  EXPECT_GT(num_partly, 100);
}

}  // namespace
}  // namespace octacut
