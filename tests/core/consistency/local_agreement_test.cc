#include "core/consistency/local_agreement.h"

#include <gtest/gtest.h>

#include <numeric>

namespace octacut {
namespace {

constexpr int kLevel = 6;

// A slab of voxels, 12 thick.
VoxelGrid Slab() {
  std::vector<MortonCode> codes;
  for (int z = 20; z < 32; ++z) {
    for (int y = 8; y < 56; ++y) {
      for (int x = 8; x < 56; ++x) {
        codes.push_back(EncodeMorton(Eigen::Vector3i(x, y, z)));
      }
    }
  }
  return VoxelGrid::FromCodes(kLevel, codes);
}

template <typename Phi>
LocalAgreement AgreementOf(const VoxelGrid& voxels, Phi&& phi_at) {
  std::vector<float> phi(voxels.Size());
  voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    phi[index] = phi_at(DecodeMorton(code));
  });
  return EstimateLocalAgreement(voxels, phi, Context(2));
}

double Mean(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         double(values.size());
}

// Any number, the same for the same voxel.
float RandomOf(const Eigen::Vector3i& voxel) {
  return float((EncodeMorton(voxel) * 2654435761u >> 7) % 1000) / 1000;
}

TEST(LocalAgreement, IsFullBesideASheetOfLowPhi) {
  const LocalAgreement agreement =
      AgreementOf(Slab(), [](const Eigen::Vector3i& voxel) {
        return voxel.z() == 25 || voxel.z() == 26 ? 0.05f : 0.7f;
      });
  EXPECT_GT(Mean(agreement.near_voxel), 0.75);
  EXPECT_GT(Mean(agreement.in_region), 0.99);
}

TEST(LocalAgreement, IsNoneOfPlainSurfaces) {
  const LocalAgreement agreement =
      AgreementOf(Slab(), [](const Eigen::Vector3i&) { return 0.5f; });
  EXPECT_EQ(Mean(agreement.near_voxel), 0);
  EXPECT_EQ(Mean(agreement.in_region), 0);
}

// The mean of phi is that of polished metal; single values are as low as any.
TEST(LocalAgreement, IsNoneOfScatteredLowValues) {
  const LocalAgreement agreement =
      AgreementOf(Slab(), [](const Eigen::Vector3i& voxel) {
        return 0.4f + 0.68f * (RandomOf(voxel) - 0.5f) + 0.3f;
      });
  EXPECT_LT(Mean(agreement.near_voxel), 0.05);
  EXPECT_EQ(Mean(agreement.in_region), 0);
}

TEST(LocalAgreement, TellsRegionsApart) {
  const VoxelGrid voxels = Slab();
  const LocalAgreement agreement =
      AgreementOf(voxels, [](const Eigen::Vector3i& voxel) {
        return voxel.x() < 32 && voxel.z() == 26 ? 0.02f : 0.6f;
      });
  voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const Eigen::Vector3i voxel = DecodeMorton(code);
    if (voxel.x() >= 40) {
      ASSERT_EQ(agreement.near_voxel[index], 0) << voxel.transpose();
    }
    if (voxel.x() >= 52) {
      ASSERT_EQ(agreement.in_region[index], 0) << voxel.transpose();
    }
  });
}

}  // namespace
}  // namespace octacut
