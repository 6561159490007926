#include "core/evidence/inside_evidence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/hull/visual_hull.h"
#include "tests/core/base/error_texts.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using testing::MakeTestScene;
using testing::TestScene;

VoxelGrid HullOf(const TestScene& test, int level) {
  VisualHullOptions options;
  options.hull_level = level;
  return ComputeVisualHull(
             test.views, TestScene::UnitBox(), options, Context(2))
      .voxels;
}

struct Shares {
  double positive = 0;
  double negative = 0;
  size_t count = 0;
};

// Shares of the voxels for which choose(world coordinates of the centre) holds.
template <typename Choose>
Shares SharesWhere(const TestScene& test,
                   const VoxelGrid& hull,
                   const InsideEvidence& evidence,
                   Choose&& choose) {
  Shares shares;
  hull.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const Eigen::Vector3d unit =
        VoxelCenter(DecodeMorton(code), hull.Level()).cast<double>();
    if (choose(testing::ToWorld(test.region.cube, unit))) {
      ++shares.count;
      shares.positive += evidence.values[index] > 0;
      shares.negative += evidence.values[index] < 0;
    }
  });
  shares.positive /= double(shares.count);
  shares.negative /= double(shares.count);
  return shares;
}

// A cup half as deep as wide, whose bottom most of the upper views see.
struct OpenCup {
  static constexpr int kLevel = 6;
  static constexpr double kTop = (0.5 + 0.15) / 2;
  static constexpr double kBottom = kTop - 0.5;

  explicit OpenCup(double contrast)
      : test(MakeTestScene(Spec(contrast))),
        hull(HullOf(test, kLevel)),
        evidence(EstimateInsideEvidence(
            test.views, hull, InsideEvidenceOptions(), 1, Context(2))) {}

  static SceneSpec Spec(double contrast) {
    SceneSpec spec = testing::OpenCupSpec(0.5);
    spec.texture.contrast = contrast;
    return spec;
  }

  Shares Cavity() const {
    const double voxel = test.VoxelSize(kLevel);
    return SharesWhere(test, hull, evidence, [&](const Eigen::Vector3d& x) {
      return x.head<2>().norm() < 0.5 - 3 * voxel &&
             x.z() > kBottom + 3 * voxel && x.z() < kTop - voxel;
    });
  }

  Shares Wall() const {
    return SharesWhere(test, hull, evidence, [&](const Eigen::Vector3d& x) {
      return std::abs(x.head<2>().norm() - 0.575) < 0.05 &&
             x.z() < kTop - 2 * test.VoxelSize(kLevel);
    });
  }

  TestScene test;
  VoxelGrid hull;
  InsideEvidence evidence;
};

TEST(InsideEvidence, IsNegativeInACavityAndPositiveInItsWalls) {
  const OpenCup cup(1);
  ASSERT_EQ(cup.evidence.values.size(), cup.hull.Size());
  EXPECT_GT(cup.Cavity().count, 500u);
  EXPECT_GT(cup.Cavity().negative, 0.9);
  EXPECT_GT(cup.Wall().count, 500u);
  EXPECT_GT(cup.Wall().positive, 0.85);
  EXPECT_LT(cup.Wall().negative, 0.05);
}

// Of a box with a texture of this contrast, the share of the samples with a
// depth.
double FoundShareOf(double contrast) {
  SceneSpec spec = testing::TestSpec("box", 240, 180, 24);
  spec.texture.contrast = contrast;
  const TestScene test = MakeTestScene(spec);
  return EstimateInsideEvidence(test.views,
                                HullOf(test, 6),
                                InsideEvidenceOptions(),
                                1,
                                Context(2))
      .summary.found_share;
}

// By its usual contrast, the sweep finds 0.23 on both boxes.
TEST(InsideEvidence, AsksForLessContrastWhereThatFindsManyMoreDepths) {
  EXPECT_GT(FoundShareOf(0.05), 0.3);
  EXPECT_LT(FoundShareOf(0), 0.25);
}

TEST(InsideEvidence, OfASolidKeepsWhatTheHullHas) {
  const TestScene test = MakeTestScene("sphere", 160, 120, 24);
  const VoxelGrid hull = HullOf(test, 5);
  const InsideEvidence evidence = EstimateInsideEvidence(
      test.views, hull, InsideEvidenceOptions(), 1, Context(2));
  const Shares inner =
      SharesWhere(test, hull, evidence, [&](const Eigen::Vector3d& x) {
        return x.norm() < 0.8 - 1.5 * test.VoxelSize(5);
      });
  EXPECT_GT(inner.count, 1000u);
  // One wrong depth is enough for half a vote, which the cut smooths away.
  EXPECT_LT(inner.negative, 0.02);
  EXPECT_GT(inner.positive, 0.9);
  EXPECT_GT(evidence.summary.num_depths, 1000u);
  EXPECT_GT(evidence.summary.num_agreeing, evidence.summary.num_depths / 2);
  EXPECT_LE(evidence.summary.num_agreeing, evidence.summary.num_depths);
}

TEST(InsideEvidence, CountsWhatItSays) {
  const TestScene test = MakeTestScene("cup", 120, 90, 16);
  const VoxelGrid hull = HullOf(test, 5);
  const InsideEvidence evidence = EstimateInsideEvidence(
      test.views, hull, InsideEvidenceOptions(), 1, Context(1));
  size_t num_free = 0;
  for (const float value : evidence.values) {
    ASSERT_TRUE(std::isfinite(value));
    num_free += value < 0;
  }
  EXPECT_EQ(evidence.summary.num_free_voxels, num_free);
  for (const int num_threads : {2, 4}) {
    EXPECT_EQ(
        EstimateInsideEvidence(
            test.views, hull, InsideEvidenceOptions(), 1, Context(num_threads))
            .values,
        evidence.values);
  }
}

// All depths that were found in a cup are judged, as wrong and as right.
TEST(ReviseEvidence, TakesWhatDoubtfulPartsOfASurfaceHaveSaid) {
  const TestScene test = MakeTestScene("cup", 120, 90, 16);
  const VoxelGrid hull = HullOf(test, 5);
  const InsideEvidenceOptions options;
  const InsideEvidence before =
      EstimateInsideEvidence(test.views, hull, options, 1, Context(2));
  ASSERT_GT(before.summary.num_free_voxels, 100u);
  const auto revised = [&](float confidence, uint8_t in_pit = 0) {
    SurfaceVerdict surface{{before.depths.maps, before.depths.confidence}, {}};
    for (std::vector<float>& of_view : surface.depths.confidence) {
      std::fill(of_view.begin(), of_view.end(), confidence);
      surface.in_pit.emplace_back(of_view.size(), in_pit);
    }
    InsideEvidence after = before;
    ReviseEvidence(test.views, hull, surface, options, Context(2), &after);
    return after;
  };
  const auto num_free = [](const InsideEvidence& evidence) {
    return std::count_if(evidence.values.begin(),
                         evidence.values.end(),
                         [](float value) { return value < 0; });
  };
  const auto mean = [](const VoxelValues& confidence) {
    double sum = 0;
    for (const float value : confidence.values) {
      sum += value;
    }
    return sum / double(confidence.values.size());
  };
  const InsideEvidence without = revised(0);
  EXPECT_EQ(num_free(without), 0);
  EXPECT_EQ(without.summary.num_free_voxels, 0u);
  EXPECT_LT(mean(without.decision_confidence), 0.2);
  EXPECT_EQ(without.depth_confidence.values, before.depth_confidence.values);
  const InsideEvidence with = revised(1);
  EXPECT_EQ(num_free(with), num_free(before));
  EXPECT_NEAR(
      mean(with.decision_confidence), mean(before.depth_confidence), 1e-3);
  // As if the whole inside of the cup were a pit.
  const InsideEvidence filled = revised(1, 1);
  EXPECT_LT(num_free(filled), 0.1 * double(num_free(before)));
}

// Where no view says anything the hull is kept.
TEST(InsideEvidence, IsTheBallooningWhereNothingIsSeen) {
  SceneSpec spec = testing::TestSpec("sphere", 120, 90, 4);  // far apart
  const TestScene test = MakeTestScene(spec);
  const VoxelGrid hull = HullOf(test, 4);
  InsideEvidenceOptions options;
  options.sweep.max_angle = 10;
  options.ballooning = 0.25;
  const InsideEvidence evidence =
      EstimateInsideEvidence(test.views, hull, options, 1, Context(2));
  EXPECT_EQ(evidence.summary.num_depths, 0u);
  for (const float value : evidence.values) {
    EXPECT_EQ(value, 0.25f);
  }
}

TEST(InsideEvidenceOptions, AreRejectedWithField) {
  EXPECT_NO_THROW(InsideEvidenceOptions().Check());
  const auto refusal = [](const auto& change) {
    return RefusalOf<InsideEvidenceOptions>(change);
  };
  EXPECT_THAT(refusal([](auto* o) { o->min_agreeing_views = 0; }),
              HasSubstr("min_agreeing_views = 0"));
  EXPECT_THAT(refusal([](auto* o) { o->min_like_samples = 10; }),
              HasSubstr("min_like_samples = 10"));
  EXPECT_THAT(refusal([](auto* o) { o->cover_rounds = 9; }),
              HasSubstr("cover_rounds = 9"));
  EXPECT_THAT(refusal([](auto* o) { o->ballooning = -0.1; }),
              HasSubstr("ballooning"));
  EXPECT_THAT(refusal([](auto* o) { o->matter_weight = -1; }),
              HasSubstr("matter_weight"));
  EXPECT_THAT(refusal([](auto* o) { o->free_space_weight = std::nan(""); }),
              HasSubstr("free_space_weight"));
  EXPECT_THAT(refusal([](auto* o) { o->sweep.max_angle = 99; }),
              HasSubstr("max_angle"));
}

}  // namespace
}  // namespace octacut
