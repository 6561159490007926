// The implicit engine against the explicit reference on random crusts of odd
// shapes: the same flow and the same labels.
#include "core/cut/implicit_cut.h"

#include <gtest/gtest.h>

#include "core/cut/cut_problem.h"
#include "tests/bench/boost_cut.h"
#include "tests/core/cut/cut_test_problems.h"

namespace octacut {
namespace {

void ExpectEqualsReference(const OctahedralCutProblem& problem) {
  const Context context(1);
  const VoxelWalk walk(*problem.crust, Context(1));
  const std::vector<FaceTies> ties = MergeFaceTies(problem, walk, context);
  const OctahedralCut expected = SolveWithBoost(problem, ties);
  // One region, a region a brick, and regions of a few bricks.
  const SearchPlan plans[] = {{.region_voxels = 1 << 20},
                              {.region_voxels = 1, .flood_bricks = 1},
                              {.region_voxels = 100, .flood_bricks = 2},
                              {.region_voxels = 333, .flood_bricks = 3}};
  for (const SearchPlan& plan : plans) {
    std::vector<FaceTies> own_ties = ties;
    const OctahedralCut actual =
        SolveImplicitly(problem, walk, own_ties, plan, context);
    ASSERT_EQ(own_ties, ties);
    ASSERT_EQ(actual.cost_fixed_point, expected.cost_fixed_point);
    ASSERT_EQ(actual.labels, expected.labels);
    ASSERT_EQ(actual.num_nodes, expected.num_nodes);
    ASSERT_EQ(LabellingCost(problem, walk, ties, actual.labels, {}, context),
              actual.cost_fixed_point);
  }
}

using Codes = std::vector<MortonCode>;
using ShapeMaker = Codes (*)(std::mt19937&);

Codes RandomBox(std::mt19937& random) {
  const Eigen::Vector3i origin(random() % 6, random() % 6, random() % 6);
  return BoxCodes(
      origin,
      {int(1 + random() % 6), int(1 + random() % 6), int(1 + random() % 6)});
}

// A box with voxels knocked out: holes, dangling voxels, components.
Codes Sponge(std::mt19937& random) {
  Codes codes = RandomBox(random);
  const unsigned percent = random() % 60;
  std::erase_if(codes, [&](MortonCode) { return random() % 100 < percent; });
  return codes;
}

// One voxel thick, wandering, touching itself.
Codes Walk(std::mt19937& random) {
  Codes codes;
  Eigen::Vector3i voxel(8, 8, 8);
  for (int step = 0; step < 60; ++step) {
    codes.push_back(EncodeMorton(voxel));
    const Eigen::Vector3i next = NeighborVoxel(voxel, int(random() % 6));
    if (next.minCoeff() >= 0 && next.maxCoeff() < 16) {
      voxel = next;
    }
  }
  return codes;
}

// A plate one voxel thick that crosses bricks.
Codes Plate(std::mt19937& random) {
  Eigen::Vector3i size(2 + random() % 8, 2 + random() % 8, 2 + random() % 8);
  size[random() % 3] = 1;
  return BoxCodes({int(random() % 6), 2, 3}, size);
}

// Scattered bricks with random masks: many components.
Codes FuzzedBricks(std::mt19937& random) {
  Codes codes;
  for (int brick = 0; brick < 4; ++brick) {
    const uint64_t key = random() % 64;
    uint64_t mask = uint64_t{random()} << 32 | random();
    for (unsigned thin = random() % 3; thin > 0; --thin) {
      mask &= uint64_t{random()} << 32 | random();
    }
    for (; mask != 0; mask &= mask - 1) {
      codes.push_back(key << 6 | uint64_t(std::countr_zero(mask)));
    }
  }
  return codes;
}

Codes FullBrick(std::mt19937& random) {
  Codes codes;
  const uint64_t key = random() % 64;
  for (uint64_t bit = 0; bit < 64; ++bit) {
    codes.push_back(key << 6 | bit);
  }
  return codes;
}

struct Case {
  const char* name;
  ShapeMaker make;
  int rounds;
};

class ImplicitCutOnShapes : public testing::TestWithParam<Case> {};

TEST_P(ImplicitCutOnShapes, EqualsTheReference) {
  std::mt19937 random(42);
  for (int round = 0; round < GetParam().rounds; ++round) {
    const VoxelGrid crust = VoxelGrid::FromCodes(4, GetParam().make(random));
    const double inside[] = {0.0, 0.02, 0.3, 0.5, 0.98};
    const double inner[] = {0.0, 0.0, 0.05, 0.5};
    OwnedCutProblem problem = TieRandomly(
        crust,
        {.inside = inside[random() % 5], .inner = inner[random() % 4]},
        random);
    SetRandomWeights(WeightKind(random() % 4), random, problem);
    const float scales[] = {0.0f, 1e-6f, 0.1f, 3.0f, 6000.0f};
    if (random() % 2) {
      SetRandomEvidence(scales[random() % 5], random, problem);
    }
    SCOPED_TRACE(round);
    ExpectEqualsReference(problem.View());
    if (HasFatalFailure()) {
      return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    ImplicitCutOnShapes,
    testing::Values(Case{"Box", RandomBox, 700},
                    Case{"Sponge", Sponge, 1200},
                    Case{"Walk", Walk, 800},
                    Case{"Plate", Plate, 600},
                    Case{"FuzzedBricks", FuzzedBricks, 800},
                    Case{"FullBrick", FullBrick, 200}),
    [](const auto& test) { return std::string(test.param.name); });

// Ties by position rather than at random: far apart, so that paths are long
// and trees deep.
TEST(ImplicitCut, EqualsTheReferenceOnLayeredCrusts) {
  std::mt19937 random(3);
  for (int round = 0; round < 60; ++round) {
    const int thickness = 2 + int(random() % 8);
    OwnedCutProblem problem;
    Codes codes = BoxCodes({1, 2, 3}, {9, 10, thickness});
    const unsigned holes = round % 3 == 0 ? 0 : 12;
    std::erase_if(codes, [&](MortonCode) { return random() % 100 < holes; });
    problem.crust = VoxelGrid::FromCodes(4, codes);
    problem.weights.assign(problem.crust.Size(), 1.0f);
    problem.ties.assign(problem.crust.Size(), 0);
    problem.crust.ForEach([&](VoxelGrid::Index i, MortonCode code) {
      const Eigen::Vector3i voxel = DecodeMorton(code);
      for (int face = 0; face < kNumFaces; ++face) {
        if (!problem.crust.Contains(NeighborVoxel(voxel, face))) {
          const bool inside = 2 * (voxel.z() - 3) > thickness;
          problem.ties[i] |= inside ? InsideTie(face) : OutsideTie(face);
        }
      }
    });
    SetRandomWeights(WeightKind(round % 4), random, problem);
    if (round % 5 == 0) {
      SetRandomEvidence(0.02f, random, problem);
    }
    SCOPED_TRACE(round);
    ExpectEqualsReference(problem.View());
    if (HasFatalFailure()) {
      return;
    }
  }
}

TEST(ImplicitCut, SameForAnyNumberOfThreadsAndRegions) {
  std::mt19937 random(9);
  Codes codes = BoxCodes({3, 3, 3}, {22, 22, 22});
  std::erase_if(codes, [&](MortonCode) { return random() % 5 == 0; });
  OwnedCutProblem problem = TieRandomly(
      VoxelGrid::FromCodes(5, codes), {.inside = 0.4, .inner = 0.01}, random);
  SetRandomWeights(WeightKind::kSpeckle, random, problem);
  SetRandomEvidence(0.05f, random, problem);
  const OctahedralCutProblem view = problem.View();
  const VoxelWalk walk(problem.crust, Context(1));
  std::vector<FaceTies> ties = MergeFaceTies(view, walk, Context(1));
  const OctahedralCut expected =
      SolveImplicitly(view, walk, ties, {}, Context(1));
  for (const int num_threads : {1, 2, 4}) {
    for (const uint32_t region_voxels : {1u, 64u, 500u, 3000u, 1u << 30}) {
      const OctahedralCut actual =
          SolveImplicitly(view,
                          walk,
                          ties,
                          {.region_voxels = region_voxels,
                           .flood_bricks = region_voxels / 64 + 1},
                          Context(num_threads));
      EXPECT_EQ(actual.labels, expected.labels);
      EXPECT_EQ(actual.cost_fixed_point, expected.cost_fixed_point);
    }
  }
}

TEST(ImplicitCut, NeedsFarLessMemoryThanAnExplicitGraph) {
  const size_t num_voxels = 100000000;
  EXPECT_LE(EstimateImplicitCutBytes(num_voxels, false, false),
            75 * num_voxels);
  EXPECT_LE(EstimateImplicitCutBytes(num_voxels, true, false), 91 * num_voxels);
  EXPECT_LE(EstimateImplicitCutBytes(num_voxels, false, true), 50 * num_voxels);
}

}  // namespace
}  // namespace octacut
