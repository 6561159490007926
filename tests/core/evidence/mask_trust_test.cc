#include "core/evidence/mask_trust.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/evidence/inside_evidence.h"
#include "core/hull/visual_hull.h"
#include "core/synthetic/move_mask_border.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::TestScene;

class MaskTrust : public ::testing::Test {
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
               moved.views, hull, InsideEvidenceOptions(), Context(2))
        .mask_trust;
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
TestScene* MaskTrust::test_ = nullptr;

TEST_F(MaskTrust, IsFullForMasksThatAreRightOrWide) {
  for (const int pixels : {0, 2}) {
    const std::vector<float> trust = Estimate(pixels, 1);
    ASSERT_EQ(trust.size(), test_->views.size());
    EXPECT_GT(*std::min_element(trust.begin(), trust.end()), 0.9f) << pixels;
  }
}

TEST_F(MaskTrust, IsNoneForMasksThatAreTooSmall) {
  const std::vector<float> trust = Estimate(-kMaskError, 1);
  EXPECT_LT(*std::max_element(trust.begin(), trust.end()), 0.1f);
}

TEST_F(MaskTrust, TellsViewsApart) {
  const std::vector<float> trust = Estimate(-kMaskError, 5);
  for (size_t i = 0; i < trust.size(); ++i) {
    if (i % 5 == 0) {
      EXPECT_LT(trust[i], 0.1f) << i;
    } else {
      EXPECT_GT(trust[i], 0.9f) << i;
    }
  }
}

TEST_F(MaskTrust, IsFullWhereNoDepthTells) {
  const std::vector<float> trust =
      EstimateMaskTrust(test_->views,
                        std::vector<SweptDepthMap>(test_->views.size()),
                        Context(1));
  EXPECT_EQ(trust, std::vector<float>(test_->views.size(), 1.0f));
}

}  // namespace
}  // namespace octacut
