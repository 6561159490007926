#include <gtest/gtest.h>

#include <vector>

#include "core/evidence/silhouette_samples.h"
#include "core/hull/visual_hull.h"
#include "core/pipeline/level_step.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

// Wrong depths that say the upper part of a hand, thin fingers, is free space.
class InitialLevelTest : public ::testing::Test {
 protected:
  InitialLevelTest() : test_(MakeTestScene("fingers", 200, 150, 16)) {
    evidence_.mask_confidence.assign(test_.views.size(), 1.0f);
    CarveHull(5);
  }

  void CarveHull(int level) {
    options_.hull.hull_level = level;
    options_.target_level = level;
    hull_ = ComputeVisualHull(
                test_.views, TestScene::UnitBox(), options_.hull, Context(2))
                .voxels;
  }

  LabeledVoxels Solve(int cover_rounds, float free_space) {
    const Eigen::AlignedBox3d& box = test_.synthetic.object.shape.box;
    evidence_.values.assign(hull_.Size(), 0.1f);
    hull_.ForEach([&](VoxelGrid::Index index, MortonCode code) {
      const Eigen::Vector3d unit =
          VoxelCenter(DecodeMorton(code), hull_.Level()).cast<double>();
      if (testing::ToWorld(test_.region.cube, unit).z() >
          box.max().z() - 0.4 * box.sizes().z()) {
        evidence_.values[index] = free_space;
      }
    });
    options_.evidence.cover_rounds = cover_rounds;
    summary_ = {};
    return SolveInitialLevel(inputs_, hull_, &summary_).surface;
  }

  double UncoveredShare(const LabeledVoxels& surface) const {
    const SampleCounts counts = CountSamples(
        MapSamples(test_.views, surface.voxels, surface.labels, Context(2)));
    return double(counts.num_uncovered) / double(counts.num_sure);
  }

  size_t NumViewsWithUncovered(const LabeledVoxels& surface) const {
    size_t num_views = 0;
    for (const SampleMap& map :
         MapSamples(test_.views, surface.voxels, surface.labels, Context(2))) {
      num_views += CountSamples({map}).num_uncovered > 0;
    }
    return num_views;
  }

  TestScene test_;
  ReconstructionOptions options_;
  VoxelGrid hull_;
  InsideEvidence evidence_;
  Context context_{2};
  LevelInputs inputs_{test_.views, evidence_, options_, context_};
  LevelSummary summary_;
};

// Thin parts that no evidence holds.
TEST_F(InitialLevelTest, OfAMirrorKeepsTheHull) {
  CarveHull(6);
  EXPECT_GT(UncoveredShare(Solve(0, 0)), 0.02);
  EXPECT_LT(summary_.consistency.num_unseen, hull_.Size() / 2);
  evidence_.is_mirror = true;
  EXPECT_LT(UncoveredShare(Solve(0, 0)), 1e-3);
  EXPECT_EQ(summary_.consistency.num_unseen, hull_.Size());
  EXPECT_EQ(summary_.decided_share, 0);
}

TEST_F(InitialLevelTest, SilhouettesAskBackWhatWrongDepthsCutOff) {
  EXPECT_GT(UncoveredShare(Solve(0, -1)), 0.02);
  EXPECT_EQ(summary_.num_cover_rounds, 0);
  const double missed = summary_.missed_after;
  EXPECT_GT(missed, 0.02);
  const LabeledVoxels covering = Solve(8, -1);
  EXPECT_EQ(UncoveredShare(covering), summary_.missed_after);
  EXPECT_EQ(summary_.missed_before, missed);
  EXPECT_GT(summary_.num_cover_rounds, 0);
  // What one view alone misses stays uncovered: three samples of 1697.
  EXPECT_LE(NumViewsWithUncovered(covering), 1u);
  EXPECT_LT(summary_.missed_after, 2e-3);
}

// However sure depths are, the second cut covers what the first one has.
TEST_F(InitialLevelTest, NoEvidenceIsStrongerThanSilhouettes) {
  EXPECT_EQ(UncoveredShare(Solve(1, -100)), summary_.missed_after);
  EXPECT_EQ(summary_.num_cover_rounds, 1);
  EXPECT_GT(summary_.num_cover_voxels, 10u);
  EXPECT_LT(summary_.missed_after, 1e-3);
}

}  // namespace
}  // namespace octacut
