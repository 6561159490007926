#include "core/evidence/mask_confidence.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/benchmark/synthetic/move_mask_border.h"
#include "core/evidence/inside_evidence.h"
#include "core/hull/visual_hull.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::TestScene;

class MaskConfidence : public ::testing::Test {
 protected:
  static constexpr int kMaskError = 3;

  // With every `step`-th mask moved by `pixels`.
  std::vector<float> Estimate(int pixels, size_t step) {
    TestScene moved = *test_;
    for (size_t i = 0; i < moved.scene.views.size(); i += step) {
      cv::Mat& mask = moved.scene.views[i].mask;
      mask = MoveMaskBorder(mask, pixels);
    }
    moved.views =
        PrepareViews(moved.scene, moved.region.cube, Context(2), kMaskError);
    VisualHullOptions options;
    options.hull_level = 6;
    const VoxelGrid hull =
        ComputeVisualHull(
            moved.views, TestScene::UnitBox(), options, Context(2))
            .voxels;
    return EstimateInsideEvidence(
               moved.views, hull, InsideEvidenceOptions(), 1, Context(2))
        .mask_confidence;
  }

  static void SetUpTestSuite() {
    test_ = new TestScene(testing::MakeTestScene("lump", 240, 180, 20));
  }
  static void TearDownTestSuite() {
    delete test_;
    test_ = nullptr;
  }
  static TestScene* test_;
};
TestScene* MaskConfidence::test_ = nullptr;

TEST_F(MaskConfidence, IsFullForMasksThatAreRightOrWide) {
  for (const int pixels : {0, 2}) {
    const std::vector<float> confidence = Estimate(pixels, 1);
    ASSERT_EQ(confidence.size(), test_->views.size());
    EXPECT_GT(*std::min_element(confidence.begin(), confidence.end()), 0.9f)
        << pixels;
  }
}

TEST_F(MaskConfidence, IsNoneForMasksThatAreTooSmall) {
  const std::vector<float> confidence = Estimate(-kMaskError, 1);
  EXPECT_LT(*std::max_element(confidence.begin(), confidence.end()), 0.1f);
}

TEST_F(MaskConfidence, TellsViewsApart) {
  const std::vector<float> confidence = Estimate(-kMaskError, 5);
  for (size_t i = 0; i < confidence.size(); ++i) {
    if (i % 5 == 0) {
      EXPECT_LT(confidence[i], 0.1f) << i;
    } else {
      EXPECT_GT(confidence[i], 0.9f) << i;
    }
  }
}

TEST_F(MaskConfidence, IsFullWhereNoDepthTells) {
  const std::vector<float> confidence =
      EstimateMaskConfidence(test_->views,
                             std::vector<SweptDepthMap>(test_->views.size()),
                             Context(1));
  EXPECT_EQ(confidence, std::vector<float>(test_->views.size(), 1.0f));
}

}  // namespace
}  // namespace octacut
