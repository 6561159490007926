#include "core/evidence/trim_hull.h"

#include <gtest/gtest.h>

#include "core/hull/visual_hull.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

TEST(TrimHull, TakesWhatReliableMasksDenyOffTheOutsideAlone) {
  TestScene test = MakeTestScene("sphere", 160, 120, 12);
  // A hole of eight by eight pixels in the middle of a mask.
  cv::Mat& mask = test.scene.views[0].mask;
  mask(cv::Rect(mask.cols / 2 - 4, mask.rows / 2 - 4, 8, 8)).setTo(0);
  test.views = PrepareViews(test.scene, test.region.cube, Context(2), 6);
  VisualHullOptions options;
  options.hull_level = 6;
  const auto hull_of = [&](const ViewSet& views) {
    return ComputeVisualHull(views, TestScene::UnitBox(), options, Context(2))
        .voxels;
  };
  const VoxelGrid hull = hull_of(test.views);
  const VoxelGrid strict =
      hull_of(PrepareViews(test.scene, test.region.cube, Context(2)));
  const auto trim = [&](float confidence, InsideEvidence* evidence) {
    evidence->mask_confidence.assign(test.views.size(), confidence);
    hull.ForEach([&](VoxelGrid::Index, MortonCode code) {
      evidence->values.push_back(float(code));
    });
    return TrimHull(test.views, hull, Context(2), evidence);
  };
  InsideEvidence evidence;
  const VoxelGrid trimmed = trim(1, &evidence);
  ASSERT_EQ(evidence.values.size(), trimmed.Size());
  trimmed.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    ASSERT_EQ(evidence.values[index], float(code));
  });
  EXPECT_LT(trimmed.Size(), hull.Size() - 1000);
  size_t num_lost = 0;
  strict.ForEach([&](VoxelGrid::Index, MortonCode code) {
    num_lost += trimmed.Find(code) == VoxelGrid::kNone;
  });
  EXPECT_EQ(num_lost, 0u);
  // The hole's tunnel is there in the strict hull and not in this one.
  const MortonCode middle = EncodeMorton(Eigen::Vector3i(32, 32, 32));
  EXPECT_EQ(strict.Find(middle), VoxelGrid::kNone);
  EXPECT_NE(trimmed.Find(middle), VoxelGrid::kNone);
  InsideEvidence doubtful;
  EXPECT_EQ(trim(0, &doubtful).Size(), hull.Size());
}

}  // namespace
}  // namespace octacut
