// Cuts that go on from the state of a smaller crust's cut: the same as anew.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/cut/cut_problem.h"
#include "tests/bench/boost_cut.h"
#include "tests/core/cut/cut_test_problems.h"
#include "tests/core/grid/codes_of.h"

namespace octacut {
namespace {

using Codes = std::vector<MortonCode>;

// What every voxel of the space a crust may grow into has.
struct Field {
  explicit Field(std::mt19937& random) {
    space = TieRandomly(
        VoxelGrid::FromCodes(4, BoxCodes({0, 0, 0}, {16, 16, 16})), {}, random);
    SetRandomWeights(WeightKind(random() % 4), random, space);
    if (random() % 2) {
      const float scales[] = {1e-6f, 0.1f, 3.0f};
      SetRandomEvidence(scales[random() % 3], random, space);
    }
    tie.resize(space.crust.Size());
    const unsigned inside_percent = std::array{2u, 30u, 50u, 98u}[random() % 4];
    for (uint8_t& inside : tie) {
      inside = random() % 100 < inside_percent;
    }
  }

  // A border face has the tie of the voxel across, or of its own where the
  // space ends: a crust that grows keeps the ties of the border it keeps.
  // With `drift` a face in so many has another one, and inner ones are tied.
  OwnedCutProblem Problem(const VoxelGrid& crust,
                          unsigned drift,
                          std::mt19937& random) const {
    OwnedCutProblem problem;
    problem.crust = crust;
    problem.ties.assign(crust.Size(), 0);
    crust.ForEach([&](VoxelGrid::Index i, MortonCode code) {
      const VoxelGrid::Index own = space.crust.Find(code);
      problem.weights.push_back(space.weights[own]);
      if (!space.evidence.empty()) {
        problem.evidence.push_back(space.evidence[own]);
      }
      for (int face = 0; face < kNumFaces; ++face) {
        const Eigen::Vector3i across = NeighborVoxel(DecodeMorton(code), face);
        const bool drifts = drift > 0 && random() % drift == 0;
        if (!crust.Contains(across) || (drifts && face % 2 == 0)) {
          const VoxelGrid::Index there = space.crust.Find(across);
          bool inside = tie[there == VoxelGrid::kNone ? own : there];
          inside ^= drifts && random() % 2 == 0;
          problem.ties[i] |= inside ? InsideTie(face) : OutsideTie(face);
        }
      }
    });
    return problem;
  }

  OwnedCutProblem space;
  std::vector<uint8_t> tie;
};

// Some of the voxels that share a face with the crust, and a few strays.
VoxelGrid Grown(const VoxelGrid& crust, std::mt19937& random) {
  Codes codes = CodesOf(crust);
  const unsigned percent = std::array{3u, 30u, 100u}[random() % 3];
  crust.ForEach([&](VoxelGrid::Index, MortonCode code) {
    for (int face = 0; face < kNumFaces; ++face) {
      const Eigen::Vector3i across = NeighborVoxel(DecodeMorton(code), face);
      if (across.minCoeff() >= 0 && across.maxCoeff() < 16 &&
          random() % 100 < percent) {
        codes.push_back(EncodeMorton(across));
      }
    }
  });
  for (unsigned strays = random() % 4; strays > 0; --strays) {
    codes.push_back(random() % 4096);
  }
  return VoxelGrid::FromCodes(4, codes);
}

VoxelGrid RandomCrust(std::mt19937& random) {
  const Eigen::Vector3i origin(
      2 + random() % 6, 2 + random() % 6, 2 + random() % 6);
  Codes codes = BoxCodes(
      origin,
      {int(1 + random() % 6), int(1 + random() % 6), int(1 + random() % 6)});
  const unsigned holes = random() % 40;
  std::erase_if(codes, [&](MortonCode) { return random() % 100 < holes; });
  return VoxelGrid::FromCodes(4, codes);
}

void ExpectSameCut(const OctahedralCut& actual, const OctahedralCut& expected) {
  ASSERT_EQ(actual.cost_fixed_point, expected.cost_fixed_point);
  ASSERT_EQ(actual.labels, expected.labels);
  ASSERT_EQ(actual.num_nodes, expected.num_nodes);
}

OctahedralCut BoostCut(const OctahedralCutProblem& problem) {
  const VoxelWalk walk(*problem.crust, Context(1));
  return SolveWithBoost(problem, MergeFaceTies(problem, walk, Context(1)));
}

// One crust that grows several times, with one state; every cut is compared.
void ExpectGrowingIsExact(unsigned drift, bool lean, std::mt19937& random) {
  const Field field(random);
  VoxelGrid crust = RandomCrust(random);
  OctahedralCutState state;
  const OctahedralCutOptions options{.lean = lean};
  for (int round = 0; round < 4; ++round) {
    SCOPED_TRACE(round);
    OwnedCutProblem problem = field.Problem(crust, drift, random);
    if (drift > 0 && random() % 3 == 0) {
      for (float& weight : problem.weights) {
        weight *= random() % 20 == 0 ? 0.5f : 1.0f;
      }
    }
    const OctahedralCut cut =
        SolveOctahedralCut(problem.View(), options, Context(1), &state);
    ExpectSameCut(cut, SolveOctahedralCut(problem.View(), options, Context(1)));
    if (!lean && !testing::Test::HasFatalFailure()) {
      ExpectSameCut(cut, BoostCut(problem.View()));
    }
    if (testing::Test::HasFatalFailure()) {
      return;
    }
    crust = Grown(crust, random);
  }
}

TEST(GrownCut, EqualsACutFromNothing) {
  std::mt19937 random(17);
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    ExpectGrowingIsExact(0, false, random);
    if (HasFatalFailure()) {
      return;
    }
  }
}

TEST(GrownCut, EqualsACutFromNothingWhateverElseChanges) {
  std::mt19937 random(18);
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    ExpectGrowingIsExact(2 + random() % 40, false, random);
    if (HasFatalFailure()) {
      return;
    }
  }
}

TEST(GrownCut, EqualsALeanCutFromNothing) {
  std::mt19937 random(19);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    ExpectGrowingIsExact(round % 2 ? 0 : 10, true, random);
    if (HasFatalFailure()) {
      return;
    }
  }
}

// Voxels of both regions of a plan, and more than one thread.
TEST(GrownCut, LargeCrustsOnAnyNumberOfThreads) {
  std::mt19937 random(20);
  Codes codes = BoxCodes({2, 2, 2}, {56, 56, 14});
  std::erase_if(codes, [&](MortonCode) { return random() % 30 == 0; });
  const VoxelGrid small = VoxelGrid::FromCodes(6, codes);
  const Codes more = BoxCodes({20, 20, 16}, {20, 20, 10});
  codes.insert(codes.end(), more.begin(), more.end());
  const VoxelGrid large = VoxelGrid::FromCodes(6, codes);
  const auto problem_of = [](const VoxelGrid& crust) {
    OwnedCutProblem problem;
    problem.crust = crust;
    problem.ties.assign(crust.Size(), 0);
    crust.ForEach([&](VoxelGrid::Index i, MortonCode code) {
      const Eigen::Vector3i voxel = DecodeMorton(code);
      problem.weights.push_back(0.01f + float(code * 2654435761u % 97) / 97);
      for (int face = 0; face < kNumFaces; ++face) {
        if (!crust.Contains(NeighborVoxel(voxel, face))) {
          problem.ties[i] |= voxel.z() > 8 ? OutsideTie(face) : InsideTie(face);
        }
      }
    });
    return problem;
  };
  const OwnedCutProblem first = problem_of(small);
  const OwnedCutProblem second = problem_of(large);
  const OctahedralCut expected =
      SolveOctahedralCut(second.View(), {}, Context(1));
  for (const int num_threads : {1, 2, 4}) {
    OctahedralCutState state;
    SolveOctahedralCut(first.View(), {}, Context(num_threads), &state);
    ExpectSameCut(
        SolveOctahedralCut(second.View(), {}, Context(num_threads), &state),
        expected);
  }
}

TEST(GrownCut, BeginsAnewWhereScaleOrEvidenceDiffer) {
  std::mt19937 random(21);
  const Field field(random);
  const VoxelGrid crust = RandomCrust(random);
  OwnedCutProblem problem = field.Problem(crust, 0, random);
  problem.evidence.clear();
  OctahedralCutState state;
  SolveOctahedralCut(problem.View(), {}, Context(1), &state);
  SetRandomEvidence(0.3f, random, problem);
  ExpectSameCut(SolveOctahedralCut(problem.View(), {}, Context(1), &state),
                BoostCut(problem.View()));
  const OctahedralCutOptions lean{.lean = true};
  ExpectSameCut(SolveOctahedralCut(problem.View(), lean, Context(1), &state),
                SolveOctahedralCut(problem.View(), lean, Context(1)));
}

TEST(GrownCut, RefusesACrustThatLacksAVoxel) {
  std::mt19937 random(22);
  OwnedCutProblem large = TieRandomly(
      VoxelGrid::FromCodes(3, BoxCodes({0, 0, 0}, {6, 3, 3})), {}, random);
  OwnedCutProblem small = TieRandomly(
      VoxelGrid::FromCodes(3, BoxCodes({0, 0, 0}, {5, 3, 3})), {}, random);
  OctahedralCutState state;
  SolveOctahedralCut(large.View(), {}, Context(1), &state);
  try {
    SolveOctahedralCut(small.View(), {}, Context(1), &state);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("lacks voxels"));
  }
  // What is left is a state without a cut.
  ExpectSameCut(SolveOctahedralCut(small.View(), {}, Context(1), &state),
                BoostCut(small.View()));
}

}  // namespace
}  // namespace octacut
