#include "core/pipeline/voxel_terms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

TEST(EdgeWeights, AreEquationThree) {
  EnergyOptions options;  // s = 4, a = 1e-5
  const std::vector<float> phi = {0, 0.1f, 0.5f, 1};
  const std::vector<float> weights = EdgeWeights(phi, options);
  ASSERT_EQ(weights.size(), 4u);
  for (size_t i = 0; i < phi.size(); ++i) {
    const double p = phi[i];
    EXPECT_NEAR(weights[i], p * p * p * p + 1e-5, 1e-7 + 1e-6 * p);
  }
  options.smoothness = 2.5;
  options.area_weight = 0.25;
  EXPECT_NEAR(EdgeWeights({0.3f}, options)[0], std::pow(0.3, 2.5) + 0.25, 1e-6);
  EXPECT_TRUE(EdgeWeights({}, options).empty());
}

// Every third voxel of a level.
VoxelGrid SomeVoxels(int level) {
  std::vector<MortonCode> codes;
  for (MortonCode code = 0; code < MortonCode{1} << (3 * level); code += 3) {
    codes.push_back(code);
  }
  return VoxelGrid::FromCodes(level, codes);
}

// Depth of a voxel's centre in a view's silhouette, voxels.
float DepthIn(const PreparedView& view, MortonCode code, int level) {
  const auto p =
      view.projection.ProjectIntoFrame(VoxelCenter(DecodeMorton(code), level));
  return p ? view.silhouette.SignedDistance(p->u, p->v) /
                 view.projection.Footprint(1.0f / float(1 << level), p->depth)
           : Silhouette::kFarInside;
}

// That in the silhouette in which the voxel lies least deep.
float LeastDepth(const ViewSet& views, MortonCode code, int level) {
  float depth = Silhouette::kFarInside;
  for (const PreparedView& view : views) {
    depth = std::min(depth, DepthIn(view, code, level));
  }
  return depth;
}

TEST(SilhouetteTerms, SpeakFromTheBorderOfTheSmallestSilhouette) {
  const TestScene test = MakeTestScene("torus", 120, 90, 12);
  constexpr int kLevel = 5;
  const VoxelGrid voxels = SomeVoxels(kLevel);
  ReconstructionOptions options;
  options.hull.hull_level = kLevel;
  options.energy.silhouette_weight = 0.75;
  options.energy.mask_border_weight = 0.3;
  const SilhouetteTerms terms =
      EstimateSilhouetteTerms(test.views,
                              std::vector<float>(test.views.size(), 1.0f),
                              voxels,
                              options,
                              Context(2));
  ASSERT_EQ(terms.evidence.size(), voxels.Size());
  size_t num_outside = 0;
  voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const float depth = LeastDepth(test.views, code, kLevel);
    num_outside += depth <= -0.5f;
    ASSERT_NEAR(terms.hull_depth[index], depth, 1e-3f) << index;
    ASSERT_NEAR(
        terms.evidence[index],
        (depth <= -0.87f ? -0.75f : -0.3f) * std::clamp(-2 * depth, 0.0f, 1.0f),
        1e-3f)
        << index;
  });
  EXPECT_GT(num_outside, voxels.Size() / 4);
  EXPECT_LT(num_outside, voxels.Size());
}

TEST(SilhouetteTerms, AreThoseOfViewsThatKnow) {
  TestScene test = MakeTestScene("torus", 120, 90, 3);
  for (View& view : test.scene.views) {
    view.unknown = cv::Mat(view.mask.size(), CV_8UC1, cv::Scalar::all(0));
    view.unknown.colRange(52, 120).setTo(255);
    view.mask.colRange(52, 120).setTo(255);
  }
  test.views = PrepareViews(test.scene, test.region.cube, Context(2));
  constexpr int kLevel = 5;
  const VoxelGrid voxels = SomeVoxels(kLevel);
  ReconstructionOptions options;
  options.hull.hull_level = kLevel;
  const SilhouetteTerms terms = EstimateSilhouetteTerms(
      test.views, std::vector<float>(3, 1), voxels, options, Context(2));
  size_t num_outside = 0;
  voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const float depth = LeastDepth(test.views, code, kLevel);
    num_outside += depth <= -0.5f;
    ASSERT_NEAR(
        std::min(terms.hull_depth[index], 20.0f), std::min(depth, 20.0f), 1e-3f)
        << index;
  });
  EXPECT_GT(num_outside, voxels.Size() / 20);
}

TEST(SilhouetteTerms, MoveWithTheShiftOfTheBorders) {
  TestScene test = MakeTestScene("torus", 120, 90, 2);
  constexpr int kLevel = 6;
  const VoxelGrid voxels = SomeVoxels(kLevel);
  ReconstructionOptions options;
  options.hull.hull_level = kLevel;
  const std::vector<float> confidence = {1, 1};
  const auto terms = [&] {
    return EstimateSilhouetteTerms(
        test.views, confidence, voxels, options, Context(2));
  };
  const SilhouetteTerms unshifted = terms();
  for (const float shift : {0.7f, -0.7f}) {
    for (PreparedView& view : test.views) {
      view.border_shift = shift;
    }
    const SilhouetteTerms shifted = terms();
    size_t num_moved = 0;
    for (size_t i = 0; i < voxels.Size(); ++i) {
      if (std::abs(unshifted.hull_depth[i]) < 5) {
        // Masks that are too large hold less.
        ASSERT_LT((shifted.hull_depth[i] - unshifted.hull_depth[i]) * shift, 0);
        ++num_moved;
      }
    }
    EXPECT_GT(num_moved, voxels.Size() / 20);
  }
}

TEST(SilhouetteTerms, AreWeakNearTheObjectAsFarAsTheMaskIsReliable) {
  TestScene test = MakeTestScene("torus", 120, 90, 2);
  constexpr double kTolerance = 4;
  test.views =
      PrepareViews(test.scene, test.region.cube, Context(2), kTolerance);
  constexpr int kInitialLevel = 6;
  const VoxelGrid voxels = SomeVoxels(kInitialLevel);
  ReconstructionOptions options;
  options.hull.hull_level = kInitialLevel;
  options.energy.silhouette_weight = 2;
  options.energy.mask_border_weight = 0.5;
  const std::vector<float> confidence = {1, 0.25f};
  const SilhouetteTerms terms = EstimateSilhouetteTerms(
      test.views, confidence, voxels, options, Context(2));
  size_t num_sure = 0;
  size_t num_weak = 0;
  size_t num_beyond_doubtful = 0;
  voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    float evidence = 0;
    for (size_t i = 0; i < 2; ++i) {
      const float depth = DepthIn(test.views[i], code, kInitialLevel);
      const auto p = test.views[i].projection.ProjectIntoFrame(
          VoxelCenter(DecodeMorton(code), kInitialLevel));
      const bool is_sure =
          p && test.views[i].silhouette.SignedDistance(p->u, p->v) +
                       0.87f * test.views[i].projection.Footprint(
                                   1.0f / (1 << kInitialLevel), p->depth) <=
                   -kTolerance;
      const float weight = is_sure ? 2 : 0.5f * confidence[i];
      evidence =
          std::min(evidence, -weight * std::clamp(-2 * depth, 0.0f, 1.0f));
      // The border of a doubtful mask does not bound the hull within its
      // tolerance.
      if (i == 1 && depth < 0 && !is_sure &&
          DepthIn(test.views[0], code, kInitialLevel) > 0) {
        ++num_beyond_doubtful;
        ASSERT_GT(terms.hull_depth[index], 0) << index;
      }
    }
    num_sure += evidence == -2;
    num_weak += evidence < 0 && evidence >= -0.5f;
    ASSERT_NEAR(terms.evidence[index], evidence, 1e-3f) << index;
  });
  EXPECT_GT(num_sure, 100u);
  EXPECT_GT(num_weak, 100u);
  EXPECT_GT(num_beyond_doubtful, 20u);

  // On finer levels only what is sure speaks.
  options.hull.hull_level = kInitialLevel - 1;
  for (const float evidence :
       EstimateSilhouetteTerms(
           test.views, confidence, voxels, options, Context(2))
           .evidence) {
    ASSERT_TRUE(evidence == 0 || evidence == -2) << evidence;
  }
}

}  // namespace
}  // namespace octacut
