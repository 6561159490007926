#include "core/segment/above_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/segment/labels.h"
#include "tests/core/segment/ring_scene.h"

namespace octacut {
namespace {

// Where the ray of a pixel meets the plane z = `height`, its distance from the
// axis; infinity where it does not.
double RadiusAt(const Pose& pose, int x, int y, double height) {
  const Rigid3d world_from_cam = pose.cam_from_world.Inverse();
  const Eigen::Vector3d direction =
      world_from_cam.rotation * pose.camera.Unproject({x + 0.5, y + 0.5});
  const double depth =
      (height - world_from_cam.translation.z()) / direction.z();
  const Eigen::Vector3d point = world_from_cam.translation + depth * direction;
  return depth > 0 ? point.head<2>().norm()
                   : std::numeric_limits<double>::infinity();
}

// A ball above a round plate. One view takes half of all that turns for
// background.
TEST(FindPixelsAbovePlate, FindsTheBallAbovePlateAndBackground) {
  constexpr double kHeight = -0.5;
  constexpr double kPlate = 0.6;
  const std::vector<Pose> poses = testing::RingPoses(12);
  std::vector<cv::Mat> labels;
  for (const Pose& pose : poses) {
    cv::Mat& of_view = labels.emplace_back(
        testing::SilhouetteOf({{0, 0, 0}, 0.45}, pose).clone());
    of_view.setTo(kNoLabel, of_view == 255);
    for (int y = 0; y < of_view.rows; ++y) {
      for (int x = 0; x < of_view.cols; ++x) {
        if (RadiusAt(pose, x, y, kHeight) < kPlate) {
          of_view.at<uint8_t>(y, x) = kNoLabel;
        }
      }
    }
  }
  labels[5].colRange(0, labels[5].cols / 2).setTo(kSurroundingsLabel);
  const std::vector<cv::Mat> above = FindPixelsAbovePlate(
      labels,
      poses,
      Eigen::Hyperplane<double, 3>(Eigen::Vector3d::UnitZ(), -kHeight),
      Context(2));
  for (size_t i = 0; i < poses.size(); ++i) {
    size_t num_above = 0;
    size_t num_wrong = 0;
    for (int y = 0; y < labels[i].rows; ++y) {
      for (int x = 0; x < labels[i].cols; ++x) {
        const bool turns = labels[i].at<uint8_t>(y, x) == kNoLabel;
        const double radius = RadiusAt(poses[i], x, y, kHeight);
        const bool is_above = turns && radius > kPlate;
        const bool is_found = above[i].at<uint8_t>(y, x) != 0;
        num_above += is_above;
        // Beside the rim, the other views' pixels are too large to tell.
        num_wrong += is_above != is_found && std::abs(radius - kPlate) > 0.3;
        EXPECT_TRUE(turns || !is_found);
      }
    }
    EXPECT_GT(num_above, 400u) << i;
    EXPECT_LT(num_wrong, 0.02 * double(num_above)) << i;
  }
}

}  // namespace
}  // namespace octacut
