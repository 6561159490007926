#include "core/evidence/depth_confidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/evidence/confidence_in_space.h"
#include "core/hull/visual_hull.h"
#include "core/raycast/ray_scene.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::TestScene;

constexpr int kDepthConfidenceLevel = 6;
constexpr float kDepthConfidenceVoxel = 1.0f / (1 << kDepthConfidenceLevel);

// A sphere's views, its hull, and the true depths of every fourth pixel.
struct DepthSetting {
  TestScene test = testing::MakeTestScene("sphere", 160, 120, 16);
  VoxelGrid hull;
  std::vector<SweptDepthMap> maps;

  DepthSetting() {
    VisualHullOptions options;
    options.hull_level = kDepthConfidenceLevel;
    hull =
        ComputeVisualHull(test.views, TestScene::UnitBox(), options, Context(2))
            .voxels;
    IndexedMesh truth = test.synthetic.reference;
    for (Eigen::Vector3d& position : truth.positions) {
      position =
          (position - test.region.cube.min_corner) / test.region.cube.edge;
    }
    const RayScene rays(truth);
    for (const PreparedView& view : test.views) {
      SweptDepthMap& map = maps.emplace_back();
      map.scale = 0.5f;
      map.width = view.projection.width / 2;
      map.height = view.projection.height / 2;
      map.depths.assign(size_t(map.width) * map.height, 1);
      std::vector<float> depths(map.depths.size());
      ForEachDepth(
          map,
          view.projection,
          [&](int x, int y, float, const Eigen::Vector3f& ray) {
            const auto hit = rays.FirstHit(
                view.projection.center.cast<double>(), ray.cast<double>());
            depths[size_t(y) * map.width + x] = hit ? float(hit->distance) : 0;
          });
      map.depths = depths;
    }
  }

  ReliableDepths Confidence(double surrounded_share = 0,
                            float shown = 1) const {
    return EstimateDepthConfidence(
        test.views, hull, maps, surrounded_share, shown, Context(2));
  }

  // The depths of a view lie so many voxels behind the truth.
  void PushBack(size_t view, float voxels) {
    for (float& depth : maps[view].depths) {
      depth = depth > 0 ? depth + voxels * kDepthConfidenceVoxel : 0;
    }
  }
};

size_t CountDepths(const SweptDepthMap& map) {
  return size_t(std::count_if(map.depths.begin(),
                              map.depths.end(),
                              [](float depth) { return depth > 0; }));
}

float MeanConfidence(const SweptDepthMap& map,
                     const std::vector<float>& confidence) {
  float sum = 0;
  for (size_t k = 0; k < confidence.size(); ++k) {
    sum += map.depths[k] > 0 ? confidence[k] : 0;
  }
  return sum / float(std::max<size_t>(CountDepths(map), 1));
}

TEST(DepthConfidence, IsFullWhereDepthsAreRight) {
  const DepthSetting setting;
  const ReliableDepths reliable = setting.Confidence();
  EXPECT_LT(reliable.contradicted_share, 0.05);
  for (size_t i = 0; i < setting.maps.size(); ++i) {
    // A few at the occluding contour graze the surface.
    EXPECT_GT(CountDepths(reliable.maps[i]),
              0.98 * double(CountDepths(setting.maps[i])))
        << i;
    EXPECT_GT(MeanConfidence(setting.maps[i], reliable.confidence[i]), 0.98f)
        << i;
  }
  const VoxelValues in_space =
      ConfidenceInSpace(setting.test.views, setting.hull, reliable, Context(2));
  ASSERT_EQ(in_space.values.size(), setting.hull.Size());
  EXPECT_GT(*std::min_element(in_space.values.begin(), in_space.values.end()),
            0.9f);
}

TEST(DepthConfidence, OfAViewThatLooksThroughSurfacesOfOthersIsNone) {
  DepthSetting setting;
  setting.PushBack(3, 9);
  const ReliableDepths reliable = setting.Confidence();
  EXPECT_LT(MeanConfidence(setting.maps[3], reliable.confidence[3]), 0.1f);
  // What it finds behind the surfaces of many others is outvoted.
  EXPECT_LT(CountDepths(reliable.maps[3]), CountDepths(setting.maps[3]) / 4);
  for (const size_t i : {size_t{0}, size_t{7}, size_t{12}}) {
    EXPECT_GT(MeanConfidence(setting.maps[i], reliable.confidence[i]), 0.9f)
        << i;
  }
}

// A view that looks through a lattice of points, so many voxels apart, at
// depths behind it: the mean confidence of these in units of that of the scene.
// All other views that look along the same axis have found the lattice, and the
// plane that it lies in around it, to `plane` voxels from its middle.
struct BehindLattice {
  float confidence = 0;
  float scene_confidence = 0;
};

BehindLattice ConfidenceBehindLattice(int spacing, int plane) {
  DepthSetting setting;
  constexpr size_t kView = 5;
  constexpr int kLattice = 15;  // half its side and that of the sphere, voxels
  const Eigen::Vector3f middle = Eigen::Vector3f::Constant(0.5f);
  const Eigen::Vector3f forward =
      (middle - setting.test.views[kView].projection.center).normalized();
  const Eigen::Vector3f right = forward.unitOrthogonal();
  const Eigen::Vector3f down = forward.cross(right);
  std::vector<size_t> others;
  for (size_t i = 0; i < setting.maps.size(); ++i) {
    std::vector<float>& depths = setting.maps[i].depths;
    std::fill(depths.begin(), depths.end(), 0.0f);
    const Eigen::Vector3f axis =
        (middle - setting.test.views[i].projection.center).normalized();
    if (i != kView && std::abs(axis.dot(forward)) > 0.7f) {
      others.push_back(i);
    }
  }
  const auto set_depth = [&](size_t view, const Eigen::Vector3f& point) {
    SweptDepthMap& map = setting.maps[view];
    const auto p = setting.test.views[view].projection.Project(point);
    const size_t x = size_t(p->u * map.scale);
    const size_t y = size_t(p->v * map.scale);
    map.depths[y * size_t(map.width) + x] = p->depth;
  };
  for (int y = -plane; y <= plane; ++y) {
    for (int x = -plane; x <= plane; ++x) {
      const Eigen::Vector3f point =
          middle + kDepthConfidenceVoxel * (float(x) * right + float(y) * down);
      const bool is_around = std::max(std::abs(x), std::abs(y)) > kLattice;
      if (!is_around) {
        set_depth(kView, point + 8 * kDepthConfidenceVoxel * forward);
      }
      if (is_around || (x % spacing == 0 && y % spacing == 0)) {
        for (const size_t view : others) {
          set_depth(view, point);
        }
      }
    }
  }
  const ReliableDepths reliable = setting.Confidence();
  return {MeanConfidence(setting.maps[kView], reliable.confidence[kView]) /
              reliable.scene_confidence,
          reliable.scene_confidence};
}

// As rays into a cup pass its rim: those that pass beside a surface are not
// contradicted by it.
TEST(DepthConfidence, HardlyFallsWhereRaysPassBesideSurfaces) {
  constexpr int kWide = 25;
  const BehindLattice wall = ConfidenceBehindLattice(1, kWide);
  const BehindLattice lattice = ConfidenceBehindLattice(6, kWide);
  EXPECT_GT(wall.scene_confidence, 0.8f);
  EXPECT_GT(lattice.scene_confidence, 0.8f);
  EXPECT_LT(wall.confidence, 0.1f);
  EXPECT_GT(lattice.confidence * lattice.scene_confidence, 0.5f);
}

// On plain objects, wrong depths follow one another from part to part.
TEST(DepthConfidence, FallsBesideSurfacesWhereTheSceneIsInDoubt) {
  const BehindLattice sure = ConfidenceBehindLattice(6, 25);
  const BehindLattice doubtful = ConfidenceBehindLattice(6, 23);
  EXPECT_GT(doubtful.scene_confidence, 0.3f);
  EXPECT_LT(doubtful.scene_confidence, 0.5f);
  EXPECT_LT(doubtful.confidence, 0.7f * sure.confidence);
}

// What polished metal does: most depths are reflections behind the surface.
TEST(DepthConfidence, IsNoneWhereMostDepthsContradictEachOther) {
  DepthSetting setting;
  for (size_t i = 0; i < setting.maps.size(); ++i) {
    if (i % 3 != 0) {
      setting.PushBack(i, 6 + 3 * float(i % 4));
    }
  }
  const ReliableDepths reliable = setting.Confidence();
  EXPECT_GT(reliable.contradicted_share, 0.4);
  const VoxelValues in_space =
      ConfidenceInSpace(setting.test.views, setting.hull, reliable, Context(2));
  double sum = 0;
  for (const float value : in_space.values) {
    ASSERT_GE(value, 0);
    ASSERT_LE(value, 1);
    sum += value;
  }
  EXPECT_LT(sum / double(in_space.values.size()), 0.75);
}

// Every `nth` depth.
void ThinOut(size_t nth, DepthSetting* setting) {
  for (SweptDepthMap& map : setting->maps) {
    for (size_t k = 0; k < map.depths.size(); ++k) {
      map.depths[k] = k % nth == 0 ? map.depths[k] : 0;
    }
  }
}

// Porcelain: a depth here and there, of which many are wrong.
TEST(DepthConfidence, IsNoneWhereDepthsAreFewAndContradictEachOther) {
  DepthSetting setting;
  for (size_t i = 0; i < setting.maps.size(); i += 2) {
    setting.PushBack(i, 9);
  }
  const ReliableDepths all = setting.Confidence();
  EXPECT_GT(all.contradicted_share, 0.25);
  EXPECT_GT(all.found_share, 0.6);
  EXPECT_GT(MeanConfidence(setting.maps[1], all.confidence[1]), 0.5f);
  ThinOut(5, &setting);
  const ReliableDepths few = setting.Confidence();
  EXPECT_GT(few.contradicted_share, 0.25);
  EXPECT_NEAR(few.found_share, all.found_share / 5, 0.02);
  for (size_t i = 0; i < setting.maps.size(); ++i) {
    EXPECT_EQ(MeanConfidence(setting.maps[i], few.confidence[i]), 0) << i;
  }
}

// A mirroring cup in few views: few depths are contradicted, but hardly any
// surface is there to contradict them.
TEST(DepthConfidence, IsLessWhereContradictionsAreManyForSoFewDepths) {
  DepthSetting setting;
  for (size_t i = 0; i < setting.maps.size(); i += 4) {
    setting.PushBack(i, 9);
  }
  const ReliableDepths dense = setting.Confidence();
  ThinOut(11, &setting);
  const ReliableDepths few = setting.Confidence();
  EXPECT_LT(few.contradicted_share, 0.16);
  EXPECT_GT(few.contradicted_share, 1.2 * few.found_share);
  EXPECT_GT(dense.contradicted_share, few.contradicted_share);
  EXPECT_EQ(dense.scene_confidence, 1);
  EXPECT_EQ(few.scene_confidence, 0);
}

TEST(DepthConfidence, IsFullWhereDepthsAreFewAndRight) {
  DepthSetting setting;
  ThinOut(5, &setting);
  const ReliableDepths few = setting.Confidence();
  for (size_t i = 0; i < setting.maps.size(); ++i) {
    EXPECT_GT(MeanConfidence(setting.maps[i], few.confidence[i]), 0.98f) << i;
  }
}

// A plain mug: a depth here and there although all views have neighbours.
TEST(DepthConfidence, IsNoneWhereViewsWithNeighborsFindNextToNothing) {
  DepthSetting setting;
  ThinOut(9, &setting);
  const ReliableDepths far_apart = setting.Confidence(0.5);
  EXPECT_EQ(far_apart.scene_confidence, 1);
  const ReliableDepths nearby = setting.Confidence(0.9);
  EXPECT_LT(nearby.found_share, 0.15);
  EXPECT_EQ(nearby.scene_confidence, 0);
  EXPECT_EQ(MeanConfidence(setting.maps[1], nearby.confidence[1]), 0);
  // Where no depth is, nothing else speaks for them.
  const VoxelValues in_space =
      ConfidenceInSpace(setting.test.views, setting.hull, nearby, Context(2));
  EXPECT_EQ(*std::max_element(in_space.values.begin(), in_space.values.end()),
            0);
}

TEST(DepthConfidence, IsNoneOfMirrorsUnlessDepthsAreDense) {
  DepthSetting setting;
  const ReliableDepths dense = setting.Confidence(0, 0);
  EXPECT_GT(dense.found_share, 0.7);
  EXPECT_EQ(dense.scene_confidence, 1);
  EXPECT_FALSE(dense.is_mirror);
  ThinOut(3, &setting);
  EXPECT_EQ(setting.Confidence(0, 0).scene_confidence, 0);
  EXPECT_TRUE(setting.Confidence(0, 0).is_mirror);
  EXPECT_FALSE(setting.Confidence(0, 0.5f).is_mirror);
  EXPECT_EQ(setting.Confidence(0, 0.5f).scene_confidence, 0.5f);
  EXPECT_EQ(setting.Confidence(0, 1).scene_confidence, 1);
}

TEST(DepthConfidence, IsTheSameForAnyNumberOfThreads) {
  DepthSetting setting;
  setting.PushBack(2, 7);
  const ReliableDepths one = EstimateDepthConfidence(
      setting.test.views, setting.hull, setting.maps, 1, 1, Context(1));
  const ReliableDepths three = EstimateDepthConfidence(
      setting.test.views, setting.hull, setting.maps, 1, 1, Context(3));
  EXPECT_EQ(one.confidence, three.confidence);
  EXPECT_EQ(one.contradicted_share, three.contradicted_share);
}

}  // namespace
}  // namespace octacut
