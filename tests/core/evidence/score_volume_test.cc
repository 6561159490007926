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

// A sphere in views of which one has four neighbours.
struct ScoredScene {
  TestScene test = MakeTestScene("sphere", 160, 120, 32);
  std::vector<SweepView> views;
  int reference = 0;
  std::vector<int> neighbors;
};

ScoredScene MakeScoredScene() {
  ScoredScene scene;
  VisualHullOptions options;
  options.hull_level = kScoreVolumeLevel;
  const VoxelGrid hull =
      ComputeVisualHull(
          scene.test.views, TestScene::UnitBox(), options, Context(2))
          .voxels;
  for (const PreparedView& view : scene.test.views) {
    scene.views.push_back(ReduceForSweep(view, hull, 2));
  }
  for (const std::vector<int>& near :
       SelectNeighborViews(scene.test.views, 4, 4, 60)) {
    if (near.size() == 4) {
      scene.neighbors = near;
      break;
    }
    ++scene.reference;
  }
  return scene;
}

// Two samples in corners of the view, at no depth, make the frame as large as
// the view.
TEST(ScorePlanes, AreTheSameWhateverTheFrame) {
  ScoredScene scene = MakeScoredScene();
  ASSERT_EQ(scene.neighbors.size(), 4u);
  const auto score = [&] {
    return ScorePlanes(
        scene.views, scene.reference, scene.neighbors, kScoreVolumeVoxel, {});
  };
  const ScoreVolume volume = score();
  cv::Mat_<float>& far = scene.views[scene.reference].far_depth;
  ASSERT_GT(volume.frame.x, 0);
  ASSERT_GT(volume.frame.y, 0);
  ASSERT_LT(volume.frame.width, far.cols);
  far(0, 0) = far(far.rows - 1, far.cols - 1) = 1e-12f;
  const ScoreVolume whole = score();
  ASSERT_EQ(whole.frame.size(), far.size());
  ASSERT_EQ(whole.num_planes, volume.num_planes);
  size_t num_scores = 0;
  for (int plane = 0; plane < volume.num_planes; ++plane) {
    for (size_t ray = 0; ray < volume.num_rays; ++ray) {
      const int x = volume.frame.x + int(ray) % volume.frame.width;
      const int y = volume.frame.y + int(ray) / volume.frame.width;
      const float value = volume.scores[plane * volume.num_rays + ray];
      num_scores += value > -1;
      EXPECT_EQ(
          value,
          whole.scores[plane * whole.num_rays + size_t(y) * far.cols + x]);
    }
  }
  EXPECT_GT(num_scores, 1000u);
}

// Three of four neighbours show something else, as if what the view shows was
// hidden from them.
TEST(ScorePlanes, OneNeighborIsEnoughWhereTheOthersDoNotSeeIt) {
  ScoredScene scene = MakeScoredScene();
  std::vector<SweepView>& views = scene.views;
  const std::vector<int>& neighbors = scene.neighbors;
  const int reference = scene.reference;
  ASSERT_EQ(neighbors.size(), 4u);
  const size_t num_seen = CountMatched(
      ScorePlanes(views, reference, neighbors, kScoreVolumeVoxel, {}));
  ASSERT_GT(num_seen, 200u);
  std::mt19937 random(1);
  for (int i = 1; i < 4; ++i) {
    for (float& grey : views[neighbors[i]].grey) {
      grey = float(random() % 256);
    }
  }
  const size_t num_alone = CountMatched(
      ScorePlanes(views, reference, neighbors, kScoreVolumeVoxel, {}, true));
  const size_t num_together = CountMatched(
      ScorePlanes(views, reference, neighbors, kScoreVolumeVoxel, {}, false));
  EXPECT_GT(double(num_alone), 0.6 * double(num_seen));
  EXPECT_LT(double(num_together), 0.8 * double(num_alone));
}

}  // namespace
}  // namespace octacut
