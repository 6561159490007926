#include <gtest/gtest.h>

#include <vector>

#include "core/hull/visual_hull.h"
#include "core/pipeline/level_step.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

// Wrong depths that say the upper part of a hand, thin fingers, is free space.
TEST(InitialLevel, SilhouettesAskBackWhatWrongDepthsCutOff) {
  const TestScene test = MakeTestScene("fingers", 200, 150, 16);
  ReconstructionOptions options;
  options.hull.hull_level = 5;
  options.target_level = 5;
  const VoxelGrid hull =
      ComputeVisualHull(
          test.views, TestScene::UnitBox(), options.hull, Context(2))
          .voxels;
  const Eigen::AlignedBox3d& box = test.synthetic.object.shape.box;
  InsideEvidence evidence;
  evidence.values.assign(hull.Size(), 0.1f);
  evidence.mask_trust.assign(test.views.size(), 1.0f);
  hull.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const Eigen::Vector3d unit =
        VoxelCenter(DecodeMorton(code), hull.Level()).cast<double>();
    if (testing::ToWorld(test.region.cube, unit).z() >
        box.max().z() - 0.4 * box.sizes().z()) {
      evidence.values[index] = -1;
    }
  });
  const auto solve = [&](int cover_rounds) {
    options.evidence.cover_rounds = cover_rounds;
    LevelSummary summary;
    SolveInitialLevel(
        test.views, hull, evidence, options, Context(2), &summary);
    return summary;
  };
  const LevelSummary believed = solve(0);
  EXPECT_EQ(believed.num_cover_rounds, 0);
  EXPECT_GT(believed.missed_after, 0.02);
  const LevelSummary covered = solve(8);
  EXPECT_EQ(covered.missed_before, believed.missed_after);
  EXPECT_GT(covered.num_cover_rounds, 0);
  EXPECT_LT(covered.missed_after, 0.1 * covered.missed_before);
}

}  // namespace
}  // namespace octacut
