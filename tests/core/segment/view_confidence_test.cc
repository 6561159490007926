#include "core/segment/view_confidence.h"

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

#include "tests/core/segment/ring_scene.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::MakeRingScene;
using testing::RingScene;

class ViewConfidenceTest : public ::testing::Test {
 protected:
  ViewConfidenceTest()
      : scene_(MakeRingScene(12, {{0, 0, 0}, 0.45})),
        segmentation_(SegmentObject(scene_.input, Context(2))),
        masks_(scene_.truth) {}

  RingScene scene_;
  Segmentation segmentation_;
  std::vector<cv::Mat> masks_;
};

TEST_F(ViewConfidenceTest, TrustsTheTruth) {
  for (const ViewConfidence& view : JudgeViews(segmentation_, masks_)) {
    EXPECT_GT(view.confidence, 0.9);
    EXPECT_THAT(view.doubt, IsEmpty());
  }
}

TEST_F(ViewConfidenceTest, DoubtsASilhouetteThatTheOthersContradict) {
  masks_[4](cv::Rect(80, 0, 80, 120)).setTo(0);
  masks_[7].setTo(0);
  const std::vector<ViewConfidence> judged = JudgeViews(segmentation_, masks_);
  EXPECT_THAT(judged[4].doubt, HasSubstr("with those of the other views"));
  EXPECT_THAT(judged[7].doubt, HasSubstr("not found"));
  EXPECT_THAT(judged[5].doubt, IsEmpty());
  EXPECT_LT(judged[4].confidence, judged[5].confidence);
}

// Most of it is there, so it agrees well with the others.
TEST_F(ViewConfidenceTest, DoubtsASilhouetteThatLacksAPart) {
  const cv::Rect box = cv::boundingRect(masks_[4]);
  // A quarter of its width is cut off; of another one, two pixels all around.
  const int width = box.width / 4;
  masks_[4](cv::Rect(box.x, box.y, width, box.height)).setTo(0);
  const cv::Mat ring = cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5});
  cv::erode(masks_[9], masks_[9], ring);
  const std::vector<ViewConfidence> judged = JudgeViews(segmentation_, masks_);
  EXPECT_GT(judged[4].agreement, 0.7);
  EXPECT_THAT(judged[4].doubt, HasSubstr("lacks a part of the object"));
  EXPECT_GT(judged[4].lost, 2 * judged[5].lost);
  EXPECT_THAT(judged[9].doubt, IsEmpty());
}

// Of few or small views, the others leave more than there is for all of them.
TEST_F(ViewConfidenceTest, TrustsSilhouettesThatAllLackAsMuch) {
  for (SegmentedView& view : segmentation_.views) {
    cv::circle(view.others, {20, 20}, 10, 1, cv::FILLED);
  }
  for (const ViewConfidence& view : JudgeViews(segmentation_, masks_)) {
    EXPECT_GT(view.lost, 0.08);
    EXPECT_THAT(view.doubt, IsEmpty());
  }
}

TEST_F(ViewConfidenceTest, DoubtsABorderThatColoursDoNotShow) {
  segmentation_.views[2].colours.setTo(-1);
  const std::vector<ViewConfidence> judged = JudgeViews(segmentation_, masks_);
  EXPECT_THAT(judged[2].doubt, HasSubstr("look alike"));
}

}  // namespace
}  // namespace octacut
