#include "core/pipeline/voxel_terms.h"

#include <gtest/gtest.h>

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

TEST(SilhouetteEvidence, SpeaksWhereAWholeVoxelIsBackgroundInAView) {
  const TestScene test = MakeTestScene("torus", 120, 90, 12);
  constexpr int kLevel = 5;
  std::vector<MortonCode> codes;
  for (MortonCode code = 0; code < 32u * 32 * 32; code += 3) {
    codes.push_back(code);
  }
  const VoxelGrid voxels = VoxelGrid::FromCodes(kLevel, codes);
  const std::vector<float> evidence =
      SilhouetteEvidence(test.views, voxels, 0.75, Context(2));
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

}  // namespace
}  // namespace octacut
