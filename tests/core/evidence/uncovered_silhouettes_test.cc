#include "core/evidence/uncovered_silhouettes.h"

#include <gtest/gtest.h>

#include "core/hull/visual_hull.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

constexpr int kUncoveredSilhouettesLevel = 5;
constexpr FaceLabels kInside = 63;

class UncoveredSilhouettesTest : public ::testing::Test {
 protected:
  UncoveredSilhouettesTest() : test_(MakeTestScene("fingers", 200, 150, 16)) {
    VisualHullOptions options;
    options.hull_level = kUncoveredSilhouettesLevel;
    hull_ = ComputeVisualHull(
                test_.views, TestScene::UnitBox(), options, Context(2))
                .voxels;
  }

  // Labels of all voxels above `z` (world) are outside.
  std::vector<FaceLabels> CutOffAbove(double z) const {
    std::vector<FaceLabels> labels(hull_.Size(), kInside);
    hull_.ForEach([&](VoxelGrid::Index index, MortonCode code) {
      if (World(code).z() > z) {
        labels[index] = 0;
      }
    });
    return labels;
  }

  Eigen::Vector3d World(MortonCode code) const {
    return testing::ToWorld(
        test_.region.cube,
        VoxelCenter(DecodeMorton(code), kUncoveredSilhouettesLevel)
            .cast<double>());
  }

  TestScene test_;
  VoxelGrid hull_;
};

TEST_F(UncoveredSilhouettesTest, TheWholeHullLeavesNone) {
  const std::vector<FaceLabels> labels(hull_.Size(), kInside);
  const UncoveredSilhouettes found =
      FindUncoveredSilhouettes(test_.views, hull_, labels, Context(2));
  EXPECT_GT(found.num_samples, 1000u);
  EXPECT_EQ(found.num_uncovered, 0u);
  EXPECT_EQ(found.shares, std::vector<float>(hull_.Size(), 0.0f));
}

TEST_F(UncoveredSilhouettesTest, WithoutMatterAllAreMissed) {
  const std::vector<FaceLabels> labels(hull_.Size(), 0);
  const UncoveredSilhouettes found =
      FindUncoveredSilhouettes(test_.views, hull_, labels, Context(2));
  EXPECT_EQ(found.num_uncovered, found.num_samples);
  // A ray's weight is shared out among its voxels: one per sample.
  double sum = 0;
  for (const float share : found.shares) {
    sum += share;
  }
  EXPECT_NEAR(sum, double(found.num_samples), 1e-3 * sum);
}

TEST_F(UncoveredSilhouettesTest, AskBackWhatIsCutOffAndNothingElse) {
  const double top = test_.synthetic.object.shape.box.max().z();
  const double bottom = test_.synthetic.object.shape.box.min().z();
  const double cut = top - 0.4 * (top - bottom);
  const UncoveredSilhouettes found = FindUncoveredSilhouettes(
      test_.views, hull_, CutOffAbove(cut), Context(2));
  EXPECT_GT(found.num_uncovered, found.num_samples / 50);
  EXPECT_LT(found.num_uncovered, found.num_samples);
  double above = 0;
  double far_below = 0;
  hull_.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const double z = World(code).z();
    if (z > cut) {
      above += found.shares[index];
    } else if (z < bottom + 0.3 * (top - bottom)) {
      far_below += found.shares[index];
    }
  });
  EXPECT_GT(above, 20 * far_below);
}

TEST_F(UncoveredSilhouettesTest, AreTheSameForAnyNumberOfThreads) {
  const std::vector<FaceLabels> labels = CutOffAbove(0.1);
  const UncoveredSilhouettes one =
      FindUncoveredSilhouettes(test_.views, hull_, labels, Context(1));
  const UncoveredSilhouettes four =
      FindUncoveredSilhouettes(test_.views, hull_, labels, Context(4));
  EXPECT_EQ(one.shares, four.shares);
  EXPECT_EQ(one.num_uncovered, four.num_uncovered);
}

}  // namespace
}  // namespace octacut
