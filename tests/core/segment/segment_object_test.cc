#include "core/segment/segment_object.h"

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/with_threads.h"
#include "core/segment/labels.h"
#include "tests/core/segment/ring_scene.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using testing::kBallColour;
using testing::kRoomColour;
using testing::MakeRingScene;
using testing::Overlap;
using testing::Paint;
using testing::RingScene;
using testing::SilhouetteOf;
using ::testing::ThrowsMessage;

TEST(SegmentObject, FindsTheObjectInEveryView) {
  const RingScene scene = MakeRingScene(12, {{0.1, 0, 0.05}, 0.45});
  const Segmentation found = SegmentObject(scene.input, Context(2));
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    EXPECT_GT(Overlap(found.views[i].mask, scene.truth[i]), 0.97) << i;
  }
}

// Every second view has a thing of the object's colour at another place, which
// one picture alone would take for object.
TEST(SegmentObject, WhatOneViewShowsAloneIsBackground) {
  RingScene scene = MakeRingScene(12, {{0, 0, 0}, 0.4});
  const cv::Rect thing(4, 20, 30, 40);
  cv::Mat where = cv::Mat::zeros(testing::kRingHeight, testing::kRingWidth, 0);
  where(thing).setTo(255);
  for (size_t i = 0; i < scene.truth.size(); i += 2) {
    Paint(where, kBallColour, i, &scene.input.views[i].image);
  }
  const Segmentation found = SegmentObject(scene.input, Context(2));
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    EXPECT_EQ(cv::countNonZero(found.views[i].mask(thing)), 0) << i;
    EXPECT_GT(Overlap(found.views[i].mask, scene.truth[i]), 0.96) << i;
  }
}

// A highlight of the surroundings' colour in one view is filled by the others.
TEST(SegmentObject, OthersFillWhatOneViewLoses) {
  RingScene scene = MakeRingScene(16, {{0, 0, 0}, 0.5});
  const cv::Rect highlight(75, 50, 8, 8);
  cv::Mat where = cv::Mat::zeros(testing::kRingHeight, testing::kRingWidth, 0);
  where(highlight).setTo(255);
  Paint(where, {240, 240, 240}, 1, &scene.input.views[3].image);
  const Segmentation found = SegmentObject(scene.input, Context(2));
  EXPECT_GT(cv::countNonZero(found.views[3].mask(highlight)), 60);
}

// A ball on a foot before a room that is painted like the ball, all of which
// but the room is known to turn.
TEST(SegmentObject, WhatTurnsAboveTheStandIsObject) {
  const testing::Ball foot{{0, 0, -0.8}, 0.4};
  RingScene scene = MakeRingScene(12, {{0, 0, 0}, 0.45});
  scene.input.floor =
      Eigen::Hyperplane<double, 3>(Eigen::Vector3d::UnitZ(), 0.43);
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    UnsegmentedView& view = scene.input.views[i];
    const cv::Mat foot_pixels = SilhouetteOf(foot, view.pose) & ~scene.truth[i];
    Paint(~scene.truth[i], kBallColour, i, &view.image);
    Paint(foot_pixels, {30, 120, 30}, i, &view.image);
    view.labels.create(scene.truth[i].size(), CV_8U);
    view.labels.setTo(kSurroundingsLabel);
    view.labels.setTo(kNoLabel, foot_pixels | scene.truth[i]);
    view.is_turntable = true;
    view.above_plate = scene.truth[i];
    std::vector<cv::Point> points;
    cv::findNonZero(foot_pixels, points);
    for (size_t k = 0; k < points.size(); k += 40) {
      view.stand_points.push_back({points[k].x + 0.5, points[k].y + 0.5});
    }
  }
  const Segmentation found = SegmentObject(scene.input, Context(2));
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    EXPECT_GT(Overlap(found.views[i].mask, scene.truth[i]), 0.95) << i;
  }
}

// A ball on a foot of its own colour, as a shadow on the stand may have it.
// What shows the stand is not object, and what hides it is, in the room's
// colour.
TEST(SegmentObject, TheStandIsNoObjectAndWhatHidesItIs) {
  const testing::Ball foot{{0, 0, -0.8}, 0.4};
  RingScene scene = MakeRingScene(12, {{0, 0, 0}, 0.45});
  const cv::Rect spot(72, 60, 16, 12);
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    UnsegmentedView& view = scene.input.views[i];
    const cv::Mat foot_pixels = SilhouetteOf(foot, view.pose) & ~scene.truth[i];
    Paint(foot_pixels, kBallColour, i, &view.image);
    foot_pixels.convertTo(view.stand, CV_32F, 1.0 / 255);
    if (i % 2 == 0) {
      cv::Mat where = cv::Mat::zeros(foot_pixels.size(), CV_8U);
      where(spot).setTo(255);
      Paint(where, kRoomColour, i, &view.image);
      view.stand.setTo(-1, where);
    }
  }
  const Segmentation found = SegmentObject(scene.input, Context(2));
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    EXPECT_GT(Overlap(found.views[i].mask, scene.truth[i]), 0.95) << i;
  }
}

TEST(SegmentObject, SaidLabelsStay) {
  RingScene scene = MakeRingScene(12, {{0, 0, 0}, 0.4});
  cv::Mat& labels = scene.input.views[2].labels;
  labels.create(scene.truth[2].size(), CV_8U);
  labels.setTo(kNoLabel);
  labels(cv::Rect(0, 0, 20, 20)).setTo(kSurroundingsLabel);
  labels(cv::Rect(78, 58, 4, 4)).setTo(kSurroundingsLabel);
  const Segmentation found = SegmentObject(scene.input, Context(2));
  EXPECT_EQ(found.views[2].mask.at<uint8_t>(60, 80), 0);
  EXPECT_EQ(found.views[2].mask.at<uint8_t>(60, 70), 255);
}

TEST(SegmentObject, SameBytesForAnyNumberOfThreads) {
  const RingScene scene = MakeRingScene(9, {{0.05, 0, 0}, 0.45});
  const Segmentation one = SegmentObject(scene.input, Context(1));
  Segmentation three;
  WithThreads(3, [&] { three = SegmentObject(scene.input, Context(3)); });
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    EXPECT_EQ(
        cv::norm(one.views[i].log_odds, three.views[i].log_odds, cv::NORM_INF),
        0)
        << i;
    EXPECT_EQ(cv::countNonZero(one.views[i].mask != three.views[i].mask), 0);
  }
}

TEST(SegmentObject, RefusesPicturesWithoutAnObject) {
  RingScene scene = MakeRingScene(8, {{0, 0, 0}, 0.4});
  const cv::Mat all(scene.truth[0].size(), CV_8U, cv::Scalar(255));
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    Paint(all, kRoomColour, i, &scene.input.views[i].image);
  }
  EXPECT_THAT([&] { SegmentObject(scene.input, Context(2)); },
              ThrowsMessage<InputError>(HasSubstr("differs from its")));
}

}  // namespace
}  // namespace octacut
