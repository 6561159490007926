#include "core/evidence/finer_depths.h"

#include <gtest/gtest.h>

#include "core/grid/morphology.h"
#include "core/hull/hull_surface.h"
#include "core/hull/visual_hull.h"
#include "tests/core/grid/codes_of.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

constexpr int kFinerDepthsLevel = 6;

// The border of the hull in a crust of five voxels, as if no depth had been
// found before.
LabeledVoxels HullSurfaceOf(const TestScene& test) {
  VisualHullOptions options;
  options.hull_level = kFinerDepthsLevel;
  const LabeledVoxels border =
      ComputeHullSurface(test.views, TestScene::UnitBox(), options, Context(2));
  LabeledVoxels surface{Dilate(border.voxels, 2, Context(2)), {}};
  surface.labels.resize(surface.voxels.Size());
  border.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    surface.labels[surface.voxels.Find(code)] = border.labels[index];
  });
  return surface;
}

VoxelValues ConfidenceOf(const LabeledVoxels& surface, float confidence) {
  return {surface.voxels,
          std::vector<float>(surface.voxels.Size(), confidence)};
}

constexpr double kCupDepth = 0.25;  // and its width is 1

// A cup whose hull is filled.
TestScene MakeCup() { return testing::MakeOpenCup(kCupDepth); }

TEST(FinerDepths, LeadIntoACavityThatTheSurfaceHasFilled) {
  const TestScene test = MakeCup();
  const LabeledVoxels surface = HullSurfaceOf(test);
  const FinerEvidence finer = FindFinerDepths(test.views,
                                              surface,
                                              ConfidenceOf(surface, 1),
                                              InsideEvidenceOptions(),
                                              Context(2));
  ASSERT_FALSE(finer.voxels.Empty());
  EXPECT_GT(finer.voxels.Size(), surface.voxels.Size() + 100);
  ASSERT_EQ(finer.values.size(), finer.voxels.Size());
  surface.voxels.ForEach([&](VoxelGrid::Index, MortonCode code) {
    EXPECT_NE(finer.voxels.Find(code), VoxelGrid::kNone);
  });
  const double voxel = test.VoxelSize(kFinerDepthsLevel);
  const double top = (kCupDepth + 0.15) / 2;
  const double bottom = top - kCupDepth;
  size_t num_cavity = 0;
  size_t num_free = 0;
  size_t num_wall = 0;
  size_t num_denied = 0;
  finer.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const Eigen::Vector3d x = testing::ToWorld(
        test.region.cube,
        VoxelCenter(DecodeMorton(code), kFinerDepthsLevel).cast<double>());
    if (x.head<2>().norm() > 0.5 - 3 * voxel) {
      return;
    }
    if (x.z() > bottom + 3 * voxel && x.z() < top - 3 * voxel) {
      ++num_cavity;
      num_free += finer.values[index] < 0;
    } else if (x.z() < bottom - voxel && x.z() > bottom - 3 * voxel) {
      ++num_wall;
      num_denied += finer.values[index] < 0;
    }
  });
  EXPECT_GT(num_cavity, 500u);
  EXPECT_GT(double(num_free), 0.5 * double(num_cavity));
  EXPECT_GT(num_wall, 50u);
  EXPECT_LT(double(num_denied), 0.1 * double(num_wall));
}

TEST(FinerDepths, AreTheSameForAnyNumberOfThreads) {
  const TestScene test = MakeCup();
  const LabeledVoxels surface = HullSurfaceOf(test);
  const VoxelValues confidence = ConfidenceOf(surface, 1);
  const FinerEvidence one = FindFinerDepths(
      test.views, surface, confidence, InsideEvidenceOptions(), Context(1));
  const FinerEvidence three = FindFinerDepths(
      test.views, surface, confidence, InsideEvidenceOptions(), Context(3));
  EXPECT_EQ(CodesOf(one.voxels), CodesOf(three.voxels));
  EXPECT_EQ(one.values, three.values);
}

TEST(FinerDepths, AreNotLookedForWhereDepthsAreNotReliedUpon) {
  const TestScene test = MakeCup();
  const LabeledVoxels surface = HullSurfaceOf(test);
  const FinerEvidence finer = FindFinerDepths(test.views,
                                              surface,
                                              ConfidenceOf(surface, 0.4f),
                                              InsideEvidenceOptions(),
                                              Context(2));
  EXPECT_TRUE(finer.voxels.Empty());
  EXPECT_TRUE(finer.values.empty());
}

TEST(FinerDepths, LeaveASurfaceThatIsRightAsItIs) {
  const TestScene test = MakeTestScene("sphere", 200, 150, 24);
  const LabeledVoxels surface = HullSurfaceOf(test);
  const FinerEvidence finer = FindFinerDepths(test.views,
                                              surface,
                                              ConfidenceOf(surface, 1),
                                              InsideEvidenceOptions(),
                                              Context(2));
  EXPECT_TRUE(finer.voxels.Empty());
}

}  // namespace
}  // namespace octacut
