#include "core/benchmark/evaluate/silhouette_agreement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/base/error.h"

namespace octacut {
namespace {

cv::Mat Square(int x, int y, int side) {
  cv::Mat mask = cv::Mat::zeros(100, 120, CV_8UC1);
  mask(cv::Rect(x, y, side, side)) = 255;
  return mask;
}

TEST(OutlinePercentile, CountsLengths) {
  const OutlineDistances distances = {{3, 1}, {1, 6}, {2, 3}};
  EXPECT_EQ(OutlinePercentile(distances, 0.5), 1);
  EXPECT_EQ(OutlinePercentile(distances, 0.8), 2);
  EXPECT_EQ(OutlinePercentile(distances, 1), 3);
  EXPECT_EQ(OutlinePercentile({}, 0.95), 0);
}

TEST(CompareSilhouettes, EqualOnesAgree) {
  OutlineDistances distances;
  const ViewSilhouette view =
      CompareSilhouettes(Square(20, 30, 40), Square(20, 30, 40), &distances);
  EXPECT_EQ(view.object_pixels, 1600u);
  EXPECT_EQ(view.mesh_pixels, 1600u);
  EXPECT_EQ(view.common_pixels, 1600u);
  EXPECT_NEAR(view.outline_max, 0, 1e-12);
  EXPECT_FALSE(distances.empty());
}

TEST(CompareSilhouettes, AShiftIsMeasuredInPixels) {
  OutlineDistances distances;
  const ViewSilhouette view =
      CompareSilhouettes(Square(20, 30, 40), Square(23, 30, 40), &distances);
  EXPECT_EQ(view.common_pixels, 37u * 40u);
  // Two sides of four are off by 3 pixels, but for their ends.
  EXPECT_NEAR(view.outline_max, 3, 1e-6);
  EXPECT_GT(view.outline_mean, 1.3);
  EXPECT_LT(view.outline_mean, 1.7);
}

TEST(CompareSilhouettes, AMissingOutlineIsAsFarAwayAsCanBe) {
  OutlineDistances distances;
  const ViewSilhouette view = CompareSilhouettes(
      Square(20, 30, 40), cv::Mat::zeros(100, 120, CV_8UC1), &distances);
  EXPECT_EQ(view.mesh_pixels, 0u);
  EXPECT_NEAR(view.outline_mean, std::hypot(100, 120), 1e-9);
  for (const auto& [distance, length] : distances) {
    EXPECT_TRUE(std::isfinite(distance));
  }
}

TEST(MeasureSilhouettes, RefusesViewsWithoutObject) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 5}, {1, 0, 5}, {0, 1, 5}};
  mesh.triangles = {{0, 1, 2}};
  View view;
  view.camera = {120, 100, 100, 100, 60, 50};
  view.mask = cv::Mat::zeros(100, 120, CV_8UC1);
  const std::vector<cv::Mat> depths = {cv::Mat::zeros(100, 120, CV_32FC1)};
  EXPECT_THROW(MeasureSilhouettes(RayScene(mesh), {view}, depths, Context(1)),
               InputError);
}

}  // namespace
}  // namespace octacut
