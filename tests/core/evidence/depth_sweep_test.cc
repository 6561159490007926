#include "core/evidence/depth_sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/hull/visual_hull.h"
#include "core/raycast/ray_scene.h"
#include "tests/core/base/error_texts.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using testing::MakeTestScene;
using testing::TestScene;

constexpr int kDepthSweepLevel = 5;

VoxelGrid HullOf(const TestScene& test) {
  VisualHullOptions options;
  options.hull_level = kDepthSweepLevel;
  return ComputeVisualHull(
             test.views, TestScene::UnitBox(), options, Context(2))
      .voxels;
}

// Depth of the true surface along a ray, in unit coordinates; 0 for none.
double TrueDepth(const TestScene& test,
                 const RayScene& rays,
                 size_t view_number,
                 const Eigen::Vector2d& pixel) {
  const View& view = test.scene.views[view_number];
  const Eigen::Vector3d direction =
      view.cam_from_world.rotation.transpose() * view.camera.Unproject(pixel);
  const auto hit = rays.FirstHit(view.Center(), direction);
  return hit ? hit->distance / test.region.cube.edge : 0;
}

class SweptDepthsOf : public ::testing::TestWithParam<const char*> {};

TEST_P(SweptDepthsOf, LieOnTheSurface) {
  const TestScene test = MakeTestScene(GetParam(), 200, 150, 24);
  const VoxelGrid hull = HullOf(test);
  const RayScene rays(test.synthetic.reference);
  std::vector<std::vector<int>> neighbors;
  DepthSweepOptions options;
  const std::vector<SweptDepthMap> maps =
      SweepDepths(test.views, hull, options, Context(2), &neighbors);
  ASSERT_EQ(maps.size(), test.views.size());
  ASSERT_EQ(neighbors.size(), test.views.size());
  std::vector<double> errors;
  size_t num_rays = 0;
  for (size_t i = 0; i < maps.size(); ++i) {
    const SweptDepthMap& map = maps[i];
    ASSERT_EQ(map.depths.size(), size_t(map.width) * map.height);
    for (int y = 0; y < map.height; ++y) {
      for (int x = 0; x < map.width; ++x) {
        const Eigen::Vector2d pixel((x + 0.5) / map.scale,
                                    (y + 0.5) / map.scale);
        const double expected = TrueDepth(test, rays, i, pixel);
        const float depth = map.depths[size_t(y) * map.width + x];
        EXPECT_EQ(map.DepthAt(float(pixel.x()), float(pixel.y())), depth);
        num_rays += expected > 0;
        if (depth > 0 && expected > 0) {
          errors.push_back(std::abs(depth - expected) *
                           (1 << kDepthSweepLevel));
        }
      }
    }
    EXPECT_EQ(map.DepthAt(-1, 5), 0);
    EXPECT_EQ(map.DepthAt(5, 1e6f), 0);
    // Where points just before the camera are; no int holds these.
    EXPECT_EQ(map.DepthAt(3e9f, 3e9f), 0);
    EXPECT_EQ(map.DepthAt(5, std::numeric_limits<float>::infinity()), 0);
  }
  ASSERT_GT(errors.size(), num_rays / 5);
  std::nth_element(
      errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.4);  // hull voxels
}

INSTANTIATE_TEST_SUITE_P(Objects,
                         SweptDepthsOf,
                         ::testing::Values("sphere", "cup"),
                         [](const auto& instance) {
                           return std::string(instance.param);
                         });

TEST(SweepDepths, FindsNothingOnAPlainObject) {
  SceneSpec spec = testing::TestSpec("sphere", 120, 90, 16);
  spec.texture.kind = TextureKind::kPlain;
  spec.lighting.lights.clear();
  const TestScene test = MakeTestScene(spec);
  std::vector<std::vector<int>> neighbors;
  const std::vector<SweptDepthMap> maps = SweepDepths(
      test.views, HullOf(test), DepthSweepOptions(), Context(2), &neighbors);
  // Rays at the outline see background; those in the middle nothing to match.
  size_t num_found = 0;
  for (size_t i = 0; i < maps.size(); ++i) {
    for (int y = -2; y <= 2; ++y) {
      for (int x = -2; x <= 2; ++x) {
        num_found += maps[i].DepthAt(float(60 + 4 * x), float(45 + 4 * y)) > 0;
      }
    }
  }
  EXPECT_LT(num_found, maps.size() * 25 / 10);
}

TEST(SweepDepths, NeedsTwoNeighboursAndIsTheSameForAnyNumberOfThreads) {
  const TestScene test = MakeTestScene("torus", 120, 90, 16);
  const VoxelGrid hull = HullOf(test);
  std::vector<std::vector<int>> neighbors;
  const auto sweep = [&](int num_threads) {
    return SweepDepths(test.views,
                       hull,
                       DepthSweepOptions(),
                       Context(num_threads),
                       &neighbors);
  };
  const std::vector<SweptDepthMap> expected = sweep(1);
  for (const int num_threads : {2, 4}) {
    const std::vector<SweptDepthMap> maps = sweep(num_threads);
    for (size_t i = 0; i < maps.size(); ++i) {
      EXPECT_EQ(maps[i].depths, expected[i].depths);
    }
  }
  // Two views have one neighbour each at best.
  const ViewSet two(test.views.begin(), test.views.begin() + 2);
  DepthSweepOptions wide;
  wide.min_angle = 0;
  wide.max_angle = 90;
  for (const SweptDepthMap& map :
       SweepDepths(two, hull, wide, Context(1), &neighbors)) {
    EXPECT_EQ(std::count(map.depths.begin(), map.depths.end(), 0.0f),
              std::ptrdiff_t(map.depths.size()));
  }
}

TEST(DepthSweepOptions, AreRejectedWithField) {
  EXPECT_NO_THROW(DepthSweepOptions().Check());
  const auto refusal = [](const auto& change) {
    return RefusalOf<DepthSweepOptions>(change);
  };
  EXPECT_THAT(refusal([](auto* o) { o->num_neighbors = 1; }),
              HasSubstr("num_neighbors = 1: must be in 2 .. 8"));
  EXPECT_THAT(refusal([](auto* o) { o->num_neighbors = 9; }),
              HasSubstr("num_neighbors"));
  EXPECT_THAT(refusal([](auto* o) { o->min_angle = 50; }),
              HasSubstr("min_angle"));
  EXPECT_THAT(refusal([](auto* o) { o->max_angle = 91; }),
              HasSubstr("max_angle"));
}

}  // namespace
}  // namespace octacut
