#include "core/cut/octahedral_cut.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"
#include "core/cut/cut_problem.h"
#include "core/cut/fixed_point.h"
#include "tests/core/cut/cut_test_problems.h"

namespace octacut {
namespace {

using testing::HasSubstr;

OctahedralCut Solve(const OwnedCutProblem& problem, int num_threads = 1) {
  return SolveOctahedralCut(problem.View(), {}, Context(num_threads));
}

void ExpectSameSummary(const OctahedralCut& actual,
                       const OctahedralCut& expected) {
  EXPECT_EQ(actual.cost_fixed_point, expected.cost_fixed_point);
  EXPECT_EQ(actual.labels, expected.labels);
  EXPECT_EQ(actual.num_nodes, expected.num_nodes);
}

// A bar of `length` voxels along x: the x- end inside, the rest outside.
OwnedCutProblem Bar(int length) {
  OwnedCutProblem problem;
  problem.crust = VoxelGrid::FromCodes(3, BoxCodes({0, 0, 0}, {length, 1, 1}));
  problem.weights.assign(length, 1.0f);
  problem.ties.assign(length, 0);
  for (int x = 0; x < length; ++x) {
    const size_t i = problem.crust.Find(Eigen::Vector3i(x, 0, 0));
    for (int face = 2; face < kNumFaces; ++face) {
      problem.ties[i] |= OutsideTie(face);
    }
  }
  problem.ties[problem.crust.Find(Eigen::Vector3i(0, 0, 0))] |= InsideTie(0);
  problem.ties[problem.crust.Find(Eigen::Vector3i(length - 1, 0, 0))] |=
      OutsideTie(1);
  return problem;
}

TEST(OctahedralCut, EmptyCrust) {
  OwnedCutProblem problem;
  const OctahedralCut cut = Solve(problem);
  EXPECT_TRUE(cut.labels.empty());
  EXPECT_EQ(cut.cost_fixed_point, 0);
  EXPECT_EQ(cut.num_nodes, 0u);
}

TEST(OctahedralCut, OneVoxelIsAllTies) {
  OwnedCutProblem problem = Bar(1);
  problem.weights[0] = 0.5f;
  const OctahedralCut cut = Solve(problem);
  EXPECT_EQ(cut.labels[0], 1);
  // Four octahedron edges join face x- to the four side faces.
  EXPECT_EQ(cut.cost_fixed_point, 4 * (1 << 19));
  EXPECT_DOUBLE_EQ(cut.cost, 2.0);
  EXPECT_EQ(cut.num_nodes, 0u);
  EXPECT_EQ(cut.num_cut_voxels, 1u);
}

TEST(OctahedralCut, CheapVoxelIsCut) {
  // Two voxels whose sides are free of choice only through the inner face.
  OwnedCutProblem problem = Bar(2);
  problem.weights = {1.0f, 0.25f};
  // Outside: 4 edges of voxel 0. Inside: none of 0's inner edges are spared,
  // all its sides are outside, so 4 more and 4 of voxel 1.
  const OctahedralCut cut = Solve(problem);
  EXPECT_EQ(cut.cost, 4.0);
  EXPECT_EQ(cut.labels[0], 1);
  EXPECT_EQ(cut.labels[1], 0);
}

TEST(OctahedralCut, TieOfEitherVoxelHolds) {
  for (const int who : {0, 1, 2}) {
    OwnedCutProblem problem = Bar(2);
    if (who != 1) {
      problem.ties[0] |= InsideTie(1);
    }
    if (who != 0) {
      problem.ties[1] |= InsideTie(0);
    }
    const OctahedralCut cut = Solve(problem);
    EXPECT_EQ(cut.num_nodes, 0u);
    EXPECT_EQ(cut.labels[0], 3);
    EXPECT_EQ(cut.labels[1], 1);
    EXPECT_EQ(cut.cost, 12.0);
  }
}

TEST(OctahedralCut, AmongMinimumCutsTheLeastOutside) {
  // The inner face costs the same either way: four edges to inside sides in
  // voxel 0, four edges to outside sides in voxel 1.
  OwnedCutProblem problem = Bar(2);
  problem.ties[0] =
      InsideTie(0) | InsideTie(2) | InsideTie(3) | InsideTie(4) | InsideTie(5);
  const OctahedralCut cut = Solve(problem);
  EXPECT_EQ(cut.cost, 4.0);
  EXPECT_EQ(cut.labels[0], kAllFaces);
  EXPECT_EQ(cut.labels[1], 1);
}

TEST(OctahedralCut, FacesThatNothingTouchesAreInside) {
  // Evidence of both voxels cancels on the inner face and all ties agree on
  // nothing: the face costs 4 + 4 whichever side it is on.
  OwnedCutProblem problem = Bar(2);
  problem.ties = {InsideTie(0) | InsideTie(2) | InsideTie(3) | OutsideTie(4) |
                      OutsideTie(5),
                  OutsideTie(1) | InsideTie(2) | InsideTie(3) | OutsideTie(4) |
                      OutsideTie(5)};
  problem.evidence = {3.0f, -3.0f};
  const OctahedralCut cut = Solve(problem);
  EXPECT_TRUE(cut.labels[0] & 2);
}

TEST(OctahedralCut, EvidenceMovesAFaceAndIsPaid) {
  OwnedCutProblem problem = Bar(2);
  // The inner face outside costs 4; inside 12. Evidence e a voxel asks 2 e/6.
  problem.evidence = {12.0f, 12.0f};
  EXPECT_EQ(Solve(problem).labels[0], 1);
  EXPECT_EQ(Solve(problem).cost, 4.0 + 4.0);
  problem.evidence = {20.0f, 30.0f};
  EXPECT_EQ(Solve(problem).labels[0], 3);
  EXPECT_EQ(Solve(problem).cost, 12.0);
  // What speaks for outside and is obeyed costs nothing.
  problem.evidence = {-12.0f, -12.0f};
  EXPECT_EQ(Solve(problem).labels[0], 1);
  EXPECT_EQ(Solve(problem).cost, 4.0);
  // Opposite evidence of the two voxels cancels.
  problem.evidence = {600.0f, -600.0f};
  EXPECT_EQ(Solve(problem).labels[0], 1);
  EXPECT_EQ(Solve(problem).cost, 4.0);
}

TEST(OctahedralCut, WeightsAreAtLeastOneUnit) {
  OwnedCutProblem problem = Bar(1);
  problem.weights = {1e-30f};
  EXPECT_EQ(Solve(problem).cost_fixed_point, 4);
}

TEST(OctahedralCut, MatchesExhaustiveSearch) {
  std::mt19937 random(7);
  const Eigen::Vector3i sizes[] = {
      {1, 1, 4}, {2, 2, 1}, {2, 2, 2}, {3, 3, 1}, {5, 2, 1}, {2, 3, 2}};
  int compared = 0;
  for (int round = 0; round < 600; ++round) {
    const Eigen::Vector3i& size = sizes[random() % 6];
    // Origins that straddle bricks.
    const Eigen::Vector3i origin(random() % 8, random() % 8, random() % 8);
    std::vector<MortonCode> codes = BoxCodes(origin, size);
    std::erase_if(codes, [&](MortonCode) { return random() % 5 == 0; });
    OwnedCutProblem problem =
        TieRandomly(VoxelGrid::FromCodes(4, codes),
                    {.inside = 0.5, .inner = size.prod() > 9 ? 0.4 : 0.1},
                    random);
    SetRandomWeights(WeightKind(random() % 4), random, problem);
    if (random() % 2) {
      SetRandomEvidence(random() % 2 ? 1.0f : 20.0f, random, problem);
    }
    const OctahedralCut cut = Solve(problem);
    if (cut.num_nodes <= 13) {
      SCOPED_TRACE(round);
      ExpectSameSummary(cut, ExhaustiveCut(problem.View()));
      ++compared;
    }
  }
  EXPECT_GT(compared, 400);
}

TEST(OctahedralCut, SameForAnyNumberOfThreads) {
  std::mt19937 random(11);
  std::vector<MortonCode> codes = BoxCodes({3, 3, 3}, {20, 20, 20});
  std::erase_if(codes, [&](MortonCode) { return random() % 4 == 0; });
  OwnedCutProblem problem = TieRandomly(
      VoxelGrid::FromCodes(5, codes), {.inside = 0.5, .inner = 0.05}, random);
  SetRandomWeights(WeightKind::kSpeckle, random, problem);
  SetRandomEvidence(0.1f, random, problem);
  const OctahedralCut expected = Solve(problem, 1);
  for (const int num_threads : {1, 2, 4}) {
    ExpectSameSummary(Solve(problem, num_threads), expected);
  }
}

TEST(OctahedralCut, FieldsAgreeWithTheLabels) {
  std::mt19937 random(5);
  OwnedCutProblem problem =
      TieRandomly(VoxelGrid::FromCodes(4, BoxCodes({1, 2, 3}, {6, 6, 6})),
                  {.inside = 0.3},
                  random);
  SetRandomWeights(WeightKind::kUniform, random, problem);
  const OctahedralCut cut = Solve(problem);
  EXPECT_EQ(cut.num_nodes, size_t(3 * 5 * 6 * 6));
  size_t num_cut = 0;
  for (const FaceLabels labels : cut.labels) {
    num_cut += IsCut(labels);
  }
  EXPECT_EQ(cut.num_cut_voxels, num_cut);
  const Context context(1);
  const VoxelWalk walk(problem.crust, Context(1));
  EXPECT_EQ(LabellingCost(problem.View(),
                          walk,
                          MergeFaceTies(problem.View(), walk, context),
                          cut.labels,
                          {},
                          context),
            cut.cost_fixed_point);
  EXPECT_DOUBLE_EQ(cut.cost, double(cut.cost_fixed_point) / 1048576);
}

TEST(OctahedralCut, NumCutEdgesCountsTheOctahedron) {
  for (int labels = 0; labels < 64; ++labels) {
    int edges = 0;
    for (int f = 0; f < kNumFaces; ++f) {
      for (int g = f + 1; g < kNumFaces; ++g) {
        edges += f / 2 != g / 2 && (((labels >> f) ^ (labels >> g)) & 1);
      }
    }
    EXPECT_EQ(NumCutEdges(FaceLabels(labels)), edges) << labels;
  }
}

std::string ErrorOf(const OwnedCutProblem& problem) {
  try {
    Solve(problem);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(OctahedralCut, RefusesSizesThatDiffer) {
  OwnedCutProblem problem = Bar(3);
  problem.weights.pop_back();
  EXPECT_THAT(ErrorOf(problem), HasSubstr("2 weights for 3 voxels"));
  problem = Bar(3);
  problem.ties.push_back(0);
  EXPECT_THAT(ErrorOf(problem), HasSubstr("4 ties for 3 voxels"));
  problem = Bar(3);
  problem.evidence = {1.0f};
  EXPECT_THAT(ErrorOf(problem), HasSubstr("1 evidence values for 3 voxels"));
  EXPECT_THROW(SolveOctahedralCut({}, {}, Context(1)), InputError);
}

TEST(OctahedralCut, RefusesBadNumbers) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const float weight : {0.0f, -1.0f, kNan, kInfinity, 1e9f}) {
    OwnedCutProblem problem = Bar(3);
    problem.weights[1] = weight;
    EXPECT_THAT(ErrorOf(problem), HasSubstr("weight of voxel (1, 0, 0)"));
  }
  for (const float evidence : {kNan, kInfinity, -kInfinity, -1e9f}) {
    OwnedCutProblem problem = Bar(3);
    problem.evidence = {0.0f, 0.0f, evidence};
    EXPECT_THAT(ErrorOf(problem), HasSubstr("evidence of voxel (2, 0, 0)"));
  }
}

TEST(OctahedralCut, RefusesBadTies) {
  OwnedCutProblem problem = Bar(3);
  problem.ties[1] &= FaceTies(~OutsideTie(3));
  EXPECT_THAT(ErrorOf(problem),
              HasSubstr("face y+ of voxel (1, 0, 0) is on the border"));
  problem = Bar(3);
  problem.ties[1] |= InsideTie(2);
  EXPECT_THAT(ErrorOf(problem),
              HasSubstr("face y- of voxel (1, 0, 0) is tied both"));
  // A contradiction between two neighbours.
  problem = Bar(3);
  problem.ties[0] |= InsideTie(1);
  problem.ties[1] |= OutsideTie(0);
  EXPECT_THAT(ErrorOf(problem), HasSubstr("tied both outside and inside"));
}

TEST(OctahedralCut, StopsWhenCancelled) {
  const std::atomic<bool> cancelled = true;
  const OwnedCutProblem problem = Bar(3);
  EXPECT_THROW(
      SolveOctahedralCut(problem.View(), {}, Context(1, nullptr, &cancelled)),
      CancelledError);
}

TEST(OctahedralCut, LabellingCostRefusesWrongLabels) {
  const OwnedCutProblem problem = Bar(2);
  const Context context(1);
  const VoxelWalk walk(problem.crust, Context(1));
  const std::vector<FaceTies> ties =
      MergeFaceTies(problem.View(), walk, context);
  const auto cost = [&](std::vector<FaceLabels> labels) {
    return LabellingCost(problem.View(), walk, ties, labels, {}, context);
  };
  EXPECT_EQ(cost({3, 1}), 12 << 20);
  EXPECT_THROW(cost({3, 0}), InvariantError);  // the shared face differs
  EXPECT_THROW(cost({2, 1}), InvariantError);  // against an inside tie
  EXPECT_THROW(cost({5, 0}), InvariantError);  // against an outside tie
}

TEST(OctahedralCut, MemoryEstimateGrowsWithVoxels) {
  EXPECT_GT(EstimateOctahedralCutBytes(1000000, false), 1000000u);
  EXPECT_GT(EstimateOctahedralCutBytes(1000000, true),
            EstimateOctahedralCutBytes(1000000, false));
}

}  // namespace
}  // namespace octacut
