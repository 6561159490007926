#include "core/print/aruco_markers.h"

#include <gtest/gtest.h>

#include "tests/core/print/marker_images.h"

namespace octacut {
namespace {

const PinholeCamera kCamera{640, 480, 800, 800, 320, 240};

TEST(DetectMarkers, CornersToAFractionOfAPixel) {
  const std::vector<PrintedMarker> markers = {{3, {-0.6, 0.4}, 0.5},
                                              {17, {0.2, 0.3}, 0.4}};
  const Rigid3d cam_from_world = LookAtOrigin({0.5, -1.5, 2.2});
  const cv::Mat image = RenderMarkers(markers, kCamera, cam_from_world);
  const auto found = DetectMarkers(image, MarkerDictionary::kFour50);
  ASSERT_EQ(found.size(), 2u);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(found[i].id, markers[i].id);
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Vector2d expected =
          kCamera.Project(cam_from_world * markers[i].Corners()[corner]);
      EXPECT_LT((found[i].corners[corner] - expected).norm(), 0.5);
      mean += (found[i].corners[corner] - expected) / 8;
    }
  }
  // Half a pixel lies between OpenCV's convention and COLMAP's.
  EXPECT_LT(mean.norm(), 0.15);
  EXPECT_TRUE(DetectMarkers(image, MarkerDictionary::kAprilTag36h11).empty());
}

TEST(DetectMarkers, AnIdThatIsSeenTwiceIsLeftOut) {
  const cv::Mat image = RenderMarkers(
      {{3, {-0.6, 0.4}, 0.5}, {3, {0.2, 0.3}, 0.4}, {4, {-0.5, -0.2}, 0.4}},
      kCamera,
      LookAtOrigin({0.1, -0.5, 2.5}));
  const auto found = DetectMarkers(image, MarkerDictionary::kFour50);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id, 4);
}

}  // namespace
}  // namespace octacut
