// Lean cuts: the exact cut of what the weights were rounded to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/cut/fixed_point.h"
#include "core/cut/octahedral_cut.h"
#include "tests/core/cut/cut_test_problems.h"

namespace octacut {
namespace {

OctahedralCut Solve(const OwnedCutProblem& problem, bool lean) {
  return SolveOctahedralCut(problem.View(), {.lean = lean}, Context(1));
}

OwnedCutProblem RandomProblem(WeightKind kind, std::mt19937& random) {
  std::vector<MortonCode> codes = BoxCodes({2, 2, 2}, {8, 7, 9});
  std::erase_if(codes, [&](MortonCode) { return random() % 6 == 0; });
  OwnedCutProblem problem = TieRandomly(
      VoxelGrid::FromCodes(4, codes), {.inside = 0.4, .inner = 0.02}, random);
  SetRandomWeights(kind, random, problem);
  return problem;
}

// Weights of the finest scale in which the greatest fits 15 bits.
void RoundWeights(OwnedCutProblem& problem) {
  CutScale scale{kCutFractionBits - kLeanFractionBits};
  const float greatest = *std::ranges::max_element(problem.weights);
  while (scale.Weight(greatest) > kMaxLeanWeight) {
    ++scale.shift;
  }
  for (float& weight : problem.weights) {
    weight =
        std::ldexp(float(scale.Weight(weight)), scale.shift - kCutFractionBits);
  }
}

TEST(LeanCut, IsTheExactCutOfTheRoundedWeights) {
  std::mt19937 random(4);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    OwnedCutProblem problem = RandomProblem(WeightKind(round % 4), random);
    const OctahedralCut lean = Solve(problem, true);
    const OctahedralCut exact = Solve(problem, false);
    EXPECT_GE(lean.cost_fixed_point, exact.cost_fixed_point);
    EXPECT_EQ(lean.num_nodes, exact.num_nodes);
    RoundWeights(problem);
    EXPECT_EQ(lean.labels, Solve(problem, false).labels);
  }
}

TEST(LeanCut, LosesLittle) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    OwnedCutProblem problem = RandomProblem(WeightKind::kUniform, random);
    SetRandomEvidence(0.1f, random, problem);
    const double exact = Solve(problem, false).cost;
    EXPECT_LE(Solve(problem, true).cost, exact * 1.002);
  }
}

TEST(LeanCut, SameForAnyNumberOfThreads) {
  std::mt19937 random(6);
  const OwnedCutProblem problem = RandomProblem(WeightKind::kSpeckle, random);
  const OctahedralCut one =
      SolveOctahedralCut(problem.View(), {.lean = true}, Context(1));
  const OctahedralCut two =
      SolveOctahedralCut(problem.View(), {.lean = true}, Context(2));
  EXPECT_EQ(one.labels, two.labels);
  EXPECT_EQ(one.cost_fixed_point, two.cost_fixed_point);
}

TEST(LeanCut, NeedsTwentyFiveBytesAVoxelLess) {
  EXPECT_GE(EstimateOctahedralCutBytes(1000000, false) -
                EstimateOctahedralCutBytes(1000000, false, true),
            size_t{25} * 1000000);
}

}  // namespace
}  // namespace octacut
