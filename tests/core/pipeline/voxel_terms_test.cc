#include "core/pipeline/voxel_terms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

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

TEST(SilhouetteEvidence, SpeaksWhereAWholeVoxelIsBackgroundInAView) {
  const TestScene test = MakeTestScene("torus", 120, 90, 12);
  constexpr int kLevel = 5;
  std::vector<MortonCode> codes;
  for (MortonCode code = 0; code < 32u * 32 * 32; code += 3) {
    codes.push_back(code);
  }
  const VoxelGrid voxels = VoxelGrid::FromCodes(kLevel, codes);
  ReconstructionOptions options;
  options.energy.silhouette_weight = 0.75;
  const std::vector<float> evidence =
      SilhouetteEvidence(test.views,
                         std::vector<float>(test.views.size(), 1.0f),
                         voxels,
                         options,
                         Context(2));
  ASSERT_EQ(evidence.size(), voxels.Size());
  size_t num_background = 0;
  voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    bool background = false;
    for (const PreparedView& view : test.views) {
      background |= view.silhouette.TestCube(
                        view.projection,
                        VoxelCenter(DecodeMorton(code), kLevel),
                        0.5f / (1 << kLevel)) == Footprint::kBackground;
    }
    num_background += background;
    ASSERT_EQ(evidence[index], background ? -0.75f : 0) << index;
  });
  EXPECT_GT(num_background, voxels.Size() / 4);
  EXPECT_LT(num_background, voxels.Size());
}

TEST(SilhouetteEvidence, IsWeakNearTheObjectAsFarAsTheMaskIsTrusted) {
  TestScene test = MakeTestScene("torus", 120, 90, 2);
  constexpr double kTolerance = 4;
  test.views =
      PrepareViews(test.scene, test.region.cube, Context(2), kTolerance);
  constexpr int kLevel = 6;
  std::vector<MortonCode> codes;
  for (MortonCode code = 0; code < 64u * 64 * 64; code += 5) {
    codes.push_back(code);
  }
  const VoxelGrid voxels = VoxelGrid::FromCodes(kLevel, codes);
  ReconstructionOptions options;
  options.hull.hull_level = kLevel - 1;
  options.energy.silhouette_weight = 2;
  options.energy.mask_border_weight = 0.5;
  const std::vector<float> evidence =
      SilhouetteEvidence(test.views, {1, 0.25f}, voxels, options, Context(2));
  std::map<float, int> counts;
  voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    bool is_sure = false;
    float expected = 0;
    for (size_t i = 0; i < 2; ++i) {
      const auto is_background = [&](float margin) {
        return test.views[i].silhouette.TestCube(
                   test.views[i].projection,
                   VoxelCenter(DecodeMorton(code), kLevel),
                   0.5f / (1 << kLevel),
                   margin) == Footprint::kBackground;
      };
      is_sure = is_sure || is_background(kTolerance);
      if (is_background(0)) {
        // Half of the weight: a level finer than l0.
        expected = std::min(expected, i == 0 ? -0.25f : -0.0625f);
      }
    }
    expected = is_sure ? -2 : expected;
    ++counts[expected];
    ASSERT_EQ(evidence[index], expected) << index;
  });
  EXPECT_EQ(counts.size(), 4u);
  for (const auto& [value, count] : counts) {
    EXPECT_GT(count, 100) << value;
  }
}

}  // namespace
}  // namespace octacut
