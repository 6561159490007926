#include "core/evidence/confirmed_depths.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/hull/visual_hull.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::TestScene;

constexpr int kDepthsLevel = 5;
constexpr float kVoxel = 1.0f / (1 << kDepthsLevel);

// A sphere's views, the hull, and maps with the depth of the middle of the cube
// at every fourth pixel.
struct Setting {
  TestScene test = testing::MakeTestScene("sphere", 120, 90, 8);
  VoxelGrid hull;
  std::vector<SweptDepthMap> maps;

  Setting() {
    VisualHullOptions options;
    options.hull_level = kDepthsLevel;
    hull =
        ComputeVisualHull(test.views, TestScene::UnitBox(), options, Context(2))
            .voxels;
    for (const PreparedView& view : test.views) {
      SweptDepthMap& map = maps.emplace_back();
      map.scale = 0.25f;
      map.width = view.projection.width / 4;
      map.height = view.projection.height / 4;
      map.depths.assign(size_t(map.width) * map.height, MiddleDepth(view));
    }
  }

  static float MiddleDepth(const PreparedView& view) {
    return view.projection.Project(Eigen::Vector3f::Constant(0.5f))->depth;
  }

  // The sample whose ray runs through the middle of the cube.
  size_t MiddleSample(size_t view) const {
    const auto p =
        test.views[view].projection.Project(Eigen::Vector3f::Constant(0.5f));
    return size_t(p->v * maps[view].scale) * maps[view].width +
           size_t(p->u * maps[view].scale);
  }
};

size_t Count(const std::vector<SweptDepthMap>& maps) {
  size_t count = 0;
  for (const SweptDepthMap& map : maps) {
    count += size_t(std::count_if(map.depths.begin(),
                                  map.depths.end(),
                                  [](float depth) { return depth > 0; }));
  }
  return count;
}

TEST(KeepAgreeing, CountsNeighborsWithTheSameDepth) {
  Setting setting;
  std::vector<std::vector<int>> neighbors(setting.maps.size());
  neighbors[0] = {1, 2, 3};
  // Only where the rays of all views meet does one plane suit them all.
  const size_t middle = setting.MiddleSample(0);
  setting.maps[3].depths[setting.MiddleSample(3)] += 3 * kVoxel;
  const auto keep = [&](int min_agreeing) {
    return KeepAgreeing(
        setting.maps,
        CountAgreeing(
            setting.test.views, setting.maps, neighbors, kVoxel, Context(2)),
        min_agreeing);
  };
  EXPECT_GT(keep(2)[0].depths[middle], 0);
  EXPECT_EQ(keep(3)[0].depths[middle], 0);
  // Views without neighbours have nobody to confirm them.
  EXPECT_EQ(Count({keep(1)[1]}), 0u);
}

TEST(KeepPlausible, RemovesWhatSamplesAroundDoNotShare) {
  Setting setting;
  const std::vector<bool> solid(setting.hull.Size());
  const size_t middle = setting.MiddleSample(0);
  for (SweptDepthMap& map : setting.maps) {
    std::fill(map.depths.begin(), map.depths.end(), 0.0f);
  }
  SweptDepthMap& map = setting.maps[0];
  const float depth = Setting::MiddleDepth(setting.test.views[0]);
  map.depths[middle] = depth;
  map.depths[middle + 1] = depth + kVoxel;
  map.depths[middle - map.width] = depth - kVoxel;
  map.depths[middle - 1] = depth + 2 * kVoxel;
  map.depths[middle + 2] = depth;
  const auto keep = [&](int min_like) {
    return KeepPlausible(setting.test.views,
                         setting.hull,
                         setting.maps,
                         solid,
                         min_like,
                         Context(2))[0]
        .depths;
  };
  EXPECT_EQ(keep(0), map.depths);
  EXPECT_EQ(keep(2)[middle], depth);
  EXPECT_EQ(keep(3)[middle], 0);
  EXPECT_EQ(keep(2)[middle + 2], 0);
}

TEST(KeepPlausible, RemovesWhatLiesBehindMatter) {
  const Setting setting;
  const auto count = [&](const std::vector<bool>& solid) {
    return Count(KeepPlausible(
        setting.test.views, setting.hull, setting.maps, solid, 0, Context(2)));
  };
  std::vector<bool> solid(setting.hull.Size());
  const size_t all = count(solid);
  EXPECT_EQ(all, Count(setting.maps));
  // One voxel near the middle, before or behind it: some rays run through it.
  const Eigen::Vector3i off_middle =
      Eigen::Vector3i::Constant(1 << (kDepthsLevel - 1)) +
      Eigen::Vector3i(4, 0, 0);
  solid[setting.hull.Find(off_middle)] = true;
  EXPECT_LT(count(solid), all);
  EXPECT_GT(count(solid), all * 9 / 10);
  // All of them: what meets the hull before the depth is gone.
  solid.assign(solid.size(), true);
  EXPECT_LT(count(solid), all);
  std::vector<SweptDepthMap> before = setting.maps;
  for (SweptDepthMap& map : before) {
    for (float& depth : map.depths) {
      depth *= 0.1f;
    }
  }
  EXPECT_EQ(
      Count(KeepPlausible(
          setting.test.views, setting.hull, before, solid, 0, Context(2))),
      all);
}

}  // namespace
}  // namespace octacut
