// The flow that a search begins with.
#include <gtest/gtest.h>

#include "core/cut/cut_problem.h"
#include "core/cut/flow_state.h"
#include "tests/core/cut/cut_test_problems.h"

namespace octacut {
namespace {

// Faces on the border: those at the top inside, all others outside.
OwnedCutProblem TieTopInside(VoxelGrid crust, int top) {
  OwnedCutProblem problem;
  problem.weights.assign(crust.Size(), 1.0f);
  problem.ties.assign(crust.Size(), 0);
  crust.ForEach([&](VoxelGrid::Index i, MortonCode code) {
    const Eigen::Vector3i voxel = DecodeMorton(code);
    for (int face = 0; face < kNumFaces; ++face) {
      if (!crust.Contains(NeighborVoxel(voxel, face))) {
        const bool inside = face == 5 && voxel.z() == top;
        problem.ties[i] |= inside ? InsideTie(face) : OutsideTie(face);
      }
    }
  });
  problem.crust = std::move(crust);
  return problem;
}

// A problem with what its state needs.
struct Start {
  explicit Start(OwnedCutProblem owned)
      : problem(std::move(owned)),
        walk(problem.crust, Context(1)),
        ties(MergeFaceTies(problem.View(), walk, Context(1))) {}

  FlowState<int32_t> State(const std::vector<uint32_t>& ends) const {
    return {problem.View(), walk, ties, ends, {}, Context(1)};
  }
  std::vector<uint32_t> OneRegion() const {
    return {uint32_t(walk.NumBricks())};
  }
  std::vector<uint32_t> RegionABrick() const {
    std::vector<uint32_t> ends;
    for (uint32_t brick = 0; brick < walk.NumBricks(); ++brick) {
      ends.push_back(brick + 1);
    }
    return ends;
  }

  OwnedCutProblem problem;
  VoxelWalk walk;
  std::vector<FaceTies> ties;
};

TEST(StraightPaths, ALineCarriesWhatItsWeakestVoxelDoes) {
  OwnedCutProblem problem =
      TieTopInside(VoxelGrid::FromCodes(4, BoxCodes({3, 3, 3}, {3, 3, 4})), 6);
  const auto index = [&](int z) {
    return problem.crust.Find(Eigen::Vector3i(4, 4, z));
  };
  problem.weights[index(4)] = 0.25f;
  problem.weights[index(5)] = 0.5f;
  const Start start(problem);
  const FlowState<int32_t> state = start.State(start.OneRegion());
  const auto flow_in = [&](int z, int face) {
    int64_t sum = 0;
    for (uint32_t way = 0; way < 4; ++way) {
      const uint32_t arc = kOctahedron.reverse[4 * uint32_t(face) + way];
      sum += FixedWeight(problem.weights[index(z)]) -
             state.Capacity(index(z), arc);
    }
    return sum;
  };
  const int64_t amount = 4 * FixedWeight(0.25f);
  EXPECT_EQ(flow_in(3, 5), amount);
  for (const int z : {4, 5}) {
    EXPECT_EQ(flow_in(z, 4), -amount) << z;
    EXPECT_EQ(flow_in(z, 5), amount) << z;
  }
  EXPECT_EQ(flow_in(6, 4), -amount);
  EXPECT_EQ(flow_in(6, 5), 4 * FixedWeight(1.0f));  // the ties of the top
}

// Every arc within its capacity, shown where it has a residual, and no node
// out of balance that search does not look at. The sum of what flows between
// faces that are not tied.
int64_t CheckAndSum(const Start& start, const FlowState<int32_t>& state) {
  int64_t sum = 0;
  start.walk.ForEach(0, start.walk.NumBricks(), [&](const VoxelSlot& slot) {
    const int tied = start.ties[slot.index] | start.ties[slot.index] >> 6;
    const uint32_t residual = state.Residual(slot.index);
    const uint32_t shown = kFreeArcs[residual >> kNumOctahedronArcs];
    for (uint32_t arc = 0; arc < kNumOctahedronArcs; ++arc) {
      const int32_t capacity = state.Capacity(slot.index, arc);
      EXPECT_GE(capacity, 0);
      EXPECT_EQ((residual >> arc) & 1,
                uint32_t(((shown >> arc) & 1) && capacity > 0));
      if ((kFreeArcs[tied & kAllFaces] >> arc) & 1) {
        const int64_t flow =
            state.Capacity(slot.index, kOctahedron.reverse[arc]) - capacity;
        sum += std::max<int64_t>(0, flow / 2);
      }
    }
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const FaceNode node{slot, axis};
      if (((tied >> (2 * axis)) & 1) == 0) {
        EXPECT_TRUE(state.Imbalance(node) == 0 || !state.StartsBalanced(node));
      }
    }
  });
  return sum;
}

TEST(StraightPaths, LeaveAFlowWithinCapacitiesOnAnyCrust) {
  std::mt19937 random(5);
  int num_carrying = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<MortonCode> codes = BoxCodes({2, 3, 1}, {7, 6, 5});
    const unsigned holes = round % 3 == 0 ? 0 : 10;
    std::erase_if(codes, [&](MortonCode) { return random() % 100 < holes; });
    VoxelGrid crust = VoxelGrid::FromCodes(4, codes);
    OwnedCutProblem problem =
        round % 2
            ? TieTopInside(std::move(crust), 5)
            : TieRandomly(
                  std::move(crust), {.inside = 0.5, .inner = 0.02}, random);
    SetRandomWeights(WeightKind(round % 4), random, problem);
    const Start start(std::move(problem));
    const int64_t sum = CheckAndSum(start, start.State(start.OneRegion()));
    EXPECT_EQ(CheckAndSum(start, start.State(start.RegionABrick())), sum);
    num_carrying += sum > 0;
  }
  EXPECT_EQ(num_carrying, 200);
}

}  // namespace
}  // namespace octacut
