#include "core/pipeline/deepen_level.h"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "core/evidence/silhouette_samples.h"
#include "core/hull/visual_hull.h"
#include "core/pipeline/level_step.h"
#include "tests/core/grid/codes_of.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::TestScene;

constexpr double kCupDepth = 0.25;  // and its width is 1

TestScene MakeCup() { return testing::MakeOpenCup(kCupDepth); }

// Solves a scene's first two levels without depths, so that what its hull fills
// is filled.
class DeepenLevelTest : public ::testing::Test {
 protected:
  explicit DeepenLevelTest(TestScene test = MakeCup())
      : test_(std::move(test)) {
    options_.hull.hull_level = 5;
    options_.target_level = 6;
    const VoxelGrid hull =
        ComputeVisualHull(
            test_.views, TestScene::UnitBox(), options_.hull, Context(2))
            .voxels;
    evidence_.values.assign(hull.Size(), 0.1f);
    evidence_.mask_confidence.assign(test_.views.size(), 1.0f);
    evidence_.depth_confidence = {hull, std::vector<float>(hull.Size(), 1.0f)};
    evidence_.decision_confidence = evidence_.depth_confidence;
    hierarchy_.Add(SolveInitialLevel(inputs_, hull, &summary_).surface);
    solved_ = SolveFinerLevel(inputs_, hierarchy_, &summary_);
  }

  LabeledVoxels Deepen() {
    return DeepenLevel(inputs_, hierarchy_, solved_, &summary_).surface;
  }

  SampleCounts Count(const LabeledVoxels& surface) const {
    return CountSamples(
        MapSamples(test_.views, surface.voxels, surface.labels, Context(2)));
  }

  TestScene test_;
  ReconstructionOptions options_;
  InsideEvidence evidence_;
  Context context_{2};
  LevelInputs inputs_{test_.views, evidence_, options_, context_};
  LabelHierarchy hierarchy_;
  SolvedLevel solved_;
  LevelSummary summary_;
};

TEST_F(DeepenLevelTest, OpensWhatIsFilledAndCoversTheSilhouettes) {
  const LabeledVoxels deepened = Deepen();
  EXPECT_EQ(summary_.num_crust_voxels, deepened.voxels.Size());
  ASSERT_GT(deepened.voxels.Size(), solved_.surface.voxels.Size());
  const double voxel = test_.VoxelSize(6);
  const double top = (kCupDepth + 0.15) / 2;
  size_t num_cavity = 0;
  size_t num_open = 0;
  deepened.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const Eigen::Vector3d x = testing::ToWorld(
        test_.region.cube, VoxelCenter(DecodeMorton(code), 6).cast<double>());
    if (x.head<2>().norm() < 0.5 - 4 * voxel && x.z() < top - 2 * voxel &&
        x.z() > top - kCupDepth + 3 * voxel) {
      ++num_cavity;
      num_open += deepened.labels[index] == 0;
    }
  });
  EXPECT_GT(num_cavity, 300u);
  EXPECT_GT(double(num_open), 0.7 * double(num_cavity));
  const SampleCounts counts = Count(deepened);
  EXPECT_LE(counts.num_uncovered,
            Count(solved_.surface).num_uncovered + counts.num_sure / 1000);
}

TEST_F(DeepenLevelTest, LeavesALevelAsItIsWhereDepthsAreNotReliedUpon) {
  evidence_.depth_confidence.values.assign(
      evidence_.depth_confidence.values.size(), 0.4f);
  const LabeledVoxels deepened = Deepen();
  EXPECT_EQ(CodesOf(deepened.voxels), CodesOf(solved_.surface.voxels));
  EXPECT_EQ(deepened.labels, solved_.surface.labels);
}

}  // namespace
}  // namespace octacut
