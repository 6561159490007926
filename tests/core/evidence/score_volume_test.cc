#include "core/evidence/score_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "core/evidence/neighbor_views.h"
#include "core/evidence/sweep_view.h"
#include "core/hull/visual_hull.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

constexpr int kScoreVolumeLevel = 5;
constexpr float kScoreVolumeVoxel = 1.0f / (1 << kScoreVolumeLevel);

// Rays of a view with a plane whose score chance does not reach.
size_t CountMatched(const ScoreVolume& volume) {
  size_t count = 0;
  for (size_t ray = 0; ray < volume.num_rays; ++ray) {
    float best = -1;
    for (int plane = 0; plane < volume.num_planes; ++plane) {
      best = std::max(best, volume.scores[plane * volume.num_rays + ray]);
    }
    count += best >= 0.7f;
  }
  return count;
}

// Three of four neighbours show something else, as if what the view shows was
// hidden from them.
TEST(ScorePlanes, OneNeighborIsEnoughWhereTheOthersDoNotSeeIt) {
  const TestScene test = MakeTestScene("sphere", 160, 120, 32);
  VisualHullOptions options;
  options.hull_level = kScoreVolumeLevel;
  const VoxelGrid hull =
      ComputeVisualHull(test.views, TestScene::UnitBox(), options, Context(2))
          .voxels;
  std::vector<SweepView> views;
  for (const PreparedView& view : test.views) {
    views.push_back(ReduceForSweep(view, hull, 2));
  }
  int reference = 0;
  std::vector<int> neighbors;
  for (const std::vector<int>& near :
       SelectNeighborViews(test.views, 4, 4, 60)) {
    if (near.size() == 4) {
      neighbors = near;
      break;
    }
    ++reference;
  }
  ASSERT_EQ(neighbors.size(), 4u);
  const size_t num_seen = CountMatched(
      ScorePlanes(views, reference, neighbors, kScoreVolumeVoxel, 2));
  ASSERT_GT(num_seen, 200u);
  std::mt19937 random(1);
  for (int i = 1; i < 4; ++i) {
    for (float& grey : views[neighbors[i]].grey) {
      grey = float(random() % 256);
    }
  }
  const size_t num_alone = CountMatched(
      ScorePlanes(views, reference, neighbors, kScoreVolumeVoxel, 2, true));
  const size_t num_together = CountMatched(
      ScorePlanes(views, reference, neighbors, kScoreVolumeVoxel, 2, false));
  EXPECT_GT(double(num_alone), 0.6 * double(num_seen));
  EXPECT_LT(double(num_together), 0.8 * double(num_alone));
}

}  // namespace
}  // namespace octacut
