#include "core/segment/above_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/segment/labels.h"
#include "tests/core/segment/plate_scene.h"

namespace octacut {
namespace {

using testing::RingScene;

// One view takes half of all that turns for background.
TEST(FindPixelsAbovePlate, FindsTheBallAbovePlateAndBackground) {
  const RingScene scene = testing::MakePlateScene(12);
  std::vector<Pose> poses;
  std::vector<cv::Mat> labels;
  for (const UnsegmentedView& view : scene.input.views) {
    poses.push_back(view.pose);
    labels.push_back(view.labels);
  }
  labels[5].colRange(0, labels[5].cols / 2).setTo(kSurroundingsLabel);
  const std::vector<cv::Mat> above =
      FindPixelsAbovePlate(labels, poses, *scene.input.floor, Context(2));
  for (size_t i = 0; i < poses.size(); ++i) {
    size_t num_above = 0;
    size_t num_wrong = 0;
    for (int y = 0; y < labels[i].rows; ++y) {
      for (int x = 0; x < labels[i].cols; ++x) {
        const bool turns = labels[i].at<uint8_t>(y, x) == kNoLabel;
        const double radius = testing::RadiusOnPlate(poses[i], x, y);
        const bool is_above = turns && radius > testing::kPlateRadius;
        const bool is_found = above[i].at<uint8_t>(y, x) != 0;
        num_above += is_above;
        // Beside the rim, the other views' pixels are too large to tell.
        num_wrong += is_above != is_found &&
                     std::abs(radius - testing::kPlateRadius) > 0.3;
        EXPECT_TRUE(turns || !is_found);
      }
    }
    EXPECT_GT(num_above, 400u) << i;
    EXPECT_LT(num_wrong, 0.02 * double(num_above)) << i;
  }
}

}  // namespace
}  // namespace octacut
