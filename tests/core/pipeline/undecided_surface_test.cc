#include "core/pipeline/undecided_surface.h"

#include <gtest/gtest.h>

#include "core/consistency/local_agreement.h"
#include "core/pipeline/voxel_terms.h"

namespace octacut {
namespace {

constexpr int kCrustLevel = 5;

// A crust of 10 voxels across z; below z = 15 is inside.
Crust FlatCrust() {
  std::vector<MortonCode> codes;
  for (int z = 10; z < 20; ++z) {
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 32; ++x) {
        codes.push_back(EncodeMorton(Eigen::Vector3i(x, y, z)));
      }
    }
  }
  Crust crust;
  crust.voxels = VoxelGrid::FromCodes(kCrustLevel, codes);
  crust.prior.resize(crust.voxels.Size());
  crust.ties.resize(crust.voxels.Size());
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const int z = DecodeMorton(code).z();
    crust.prior[index] = z < 15 ? 1 : 0;
    crust.ties[index] = z == 10   ? InsideTie(4)
                        : z == 19 ? OutsideTie(5)
                                  : FaceTies(0);
  });
  return crust;
}

Decision Decided(const Crust& crust, float here, float around) {
  return {std::vector<float>(crust.voxels.Size(), here),
          std::vector<float>(crust.voxels.Size(), around)};
}

// Evidence by z, far from the sides, for a hull whose border is at z = top.
std::vector<float> Held(const Decision& decision, float top) {
  const Crust crust = FlatCrust();
  std::vector<float> depth(crust.voxels.Size());
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    depth[index] = top - (float(DecodeMorton(code).z()) + 0.5f);
  });
  std::vector<float> evidence(crust.voxels.Size());
  HoldUndecidedSurface(crust, decision, depth, Context(2), &evidence);
  std::vector<float> by_z;
  for (int z = 10; z < 20; ++z) {
    by_z.push_back(evidence[crust.voxels.Find(Eigen::Vector3i(16, 16, z))]);
  }
  return by_z;
}

// How far a crust in which all voxels have a low phi is decided, by the
// confidence in depths found on a grid of `depth_level`.
float DecidedByAgreement(float confidence, int depth_level) {
  const Crust crust = FlatCrust();
  std::vector<MortonCode> codes;
  crust.voxels.ForEach([&](VoxelGrid::Index, MortonCode code) {
    for (int level = kCrustLevel; level > depth_level; --level) {
      code = ParentCode(code);
    }
    codes.push_back(code);
  });
  VoxelValues depth_confidence{VoxelGrid::FromCodes(depth_level, codes), {}};
  depth_confidence.values.assign(depth_confidence.voxels.Size(), confidence);
  const Decision decision =
      DecideByPhotographs(crust,
                          std::vector<float>(crust.voxels.Size(), 0.1f),
                          depth_confidence,
                          Context(2));
  return decision.here[crust.voxels.Find(Eigen::Vector3i(16, 16, 15))];
}

TEST(UndecidedSurface, CoarseAgreementDecidesOnlyWhereDepthsAreReliedUpon) {
  EXPECT_EQ(DecidedByAgreement(0, kCrustLevel), 0);
  EXPECT_NEAR(DecidedByAgreement(0.25f, kCrustLevel - 1), 0.5f, 1e-5f);
  EXPECT_EQ(DecidedByAgreement(0.5f, kCrustLevel), 1);
}

TEST(UndecidedSurface, FineAgreementDecidesWhateverDepthsSay) {
  EXPECT_EQ(DecidedByAgreement(0, kCrustLevel - 2), 1);
  EXPECT_EQ(DecidedByAgreement(1, kCrustLevel - 2), 1);
}

TEST(UndecidedSurface, StaysWhereTheCoarserOneIs) {
  const std::vector<float> held = Held(Decided(FlatCrust(), 0, 1), 40);
  for (int k = 0; k < 5; ++k) {
    EXPECT_GT(held[size_t(k)], 0) << k;
    EXPECT_NEAR(held[size_t(k)], -held[size_t(9 - k)], 1e-5f) << k;
  }
  EXPECT_GT(held[2], held[4]);
}

TEST(UndecidedSurface, IsFreeWherePhotographsDecide) {
  for (const float value : Held(Decided(FlatCrust(), 1, 1), 16)) {
    EXPECT_EQ(value, 0);
  }
}

TEST(UndecidedSurface, GoesToTheBorderOfAHullThatIsNear) {
  // The border is two voxels outside the coarser surface.
  const std::vector<float> let_out = Held(Decided(FlatCrust(), 0, 0), 17);
  EXPECT_GT(let_out[5], 0.1f);
  EXPECT_GT(let_out[6], 0.1f);
  EXPECT_LT(let_out[7], -0.1f);
  // Not where what is around is decided,
  EXPECT_LT(Held(Decided(FlatCrust(), 0, 1), 17)[6], 0);
  // nor where the hull is far.
  EXPECT_LT(Held(Decided(FlatCrust(), 0, 0), 22)[6], 0);
}

TEST(UndecidedSurface, OfAMirrorIsTheHull) {
  std::vector<float> evidence(4, 0.01f);
  HoldHull({-1, -0.25f, 0, 9}, &evidence);
  EXPECT_LT(evidence[0], evidence[1]);
  EXPECT_LT(evidence[1], 0);
  // Both faces of a plate of one voxel cost this much: four edges each.
  const float faces = 8 * NeutralWeight(ReconstructionOptions());
  EXPECT_GT(evidence[2], faces);
  EXPECT_GT(evidence[3], faces);
}

// As voxels of mirrors have it, whatever the confidence in depths.
TEST(UndecidedSurface, NeutralPhotoConsistencyDecidesNothing) {
  const Crust crust = FlatCrust();
  const float neutral = float(ReconstructionOptions().consistency.neutral);
  const Decision decision =
      DecideByPhotographs(crust,
                          std::vector<float>(crust.voxels.Size(), neutral),
                          {VoxelGrid::FromCodes(0, {0}), {1.0f}},
                          Context(2));
  EXPECT_EQ(decision.here, std::vector<float>(crust.voxels.Size()));
}

TEST(UndecidedSurface, CostsWhatNobodySees) {
  const ReconstructionOptions options;
  const std::vector<float> phi = {0.9f, 0.1f, 0.9f, 0.1f};
  const Decision decision{{1, 1, 0, 0}, {1, 1, 0, 0}};
  const std::vector<float> weights = DecidedWeights(decision, phi, options);
  const std::vector<float> decided = EdgeWeights(phi, options.energy);
  const float unseen =
      EdgeWeights({float(options.consistency.neutral)}, options.energy)[0];
  EXPECT_NEAR(weights[0], decided[0], 1e-6f);
  EXPECT_NEAR(weights[1], decided[1], 1e-6f);
  EXPECT_NEAR(weights[2], unseen, 1e-6f);
  EXPECT_NEAR(weights[3], unseen, 1e-6f);
}

TEST(UndecidedSurface, AgreementCountsAsFarAsDepthsDo) {
  const Crust crust = FlatCrust();
  // Some agreement: less than most of the region.
  std::vector<float> phi(crust.voxels.Size(), 0.6f);
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const Eigen::Vector3i voxel = DecodeMorton(code);
    if (voxel.x() < 10 && voxel.z() == 15) {
      phi[index] = 0;
    }
  });
  const LocalAgreement agreement =
      EstimateLocalAgreement(crust.voxels, phi, Context(2));
  const VoxelValues half_reliable{VoxelGrid::FromCodes(0, {0}), {0.5f}};
  const Decision decision =
      DecideByPhotographs(crust, phi, half_reliable, Context(2));
  int num_doubtful = 0;
  int num_counted = 0;
  for (size_t i = 0; i < phi.size(); ++i) {
    const float near = agreement.near_voxel[i];
    if (near > 0 && agreement.in_region[i] < 0.5f) {
      ++num_doubtful;
      ASSERT_NEAR(decision.here[i], 0.5f * near, 1e-6f) << i;
    } else if (near > 0) {
      ++num_counted;
      ASSERT_GE(decision.here[i], 0.5f * near) << i;
    }
  }
  EXPECT_GT(num_doubtful, 100);
  EXPECT_GT(num_counted, 100);
}

}  // namespace
}  // namespace octacut
