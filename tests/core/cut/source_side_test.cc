#include "core/cut/source_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/error.h"
#include "core/cut/cut_problem.h"
#include "tests/core/cut/cut_test_problems.h"

namespace octacut {
namespace {

// A block all of whose nodes one source node reaches: nothing flows, since
// every face of the border is outside.
struct ReachedBlock {
  ReachedBlock() : walk(problem.crust, Context(1)) {}

  FlowState<int32_t> State() {
    const std::vector<uint32_t> one_region = {uint32_t(walk.NumBricks())};
    FlowState<int32_t> state(
        problem.View(), walk, ties, one_region, {}, Context(1));
    const VoxelGrid::Index middle =
        problem.crust.Find(Eigen::Vector3i(30, 30, 20));
    walk.ForEach(0, walk.NumBricks(), [&](const VoxelSlot& slot) {
      if (slot.index == middle) {
        state.Word(FaceNode{slot, 0}) = kSourceNode;
      }
    });
    return state;
  }

  std::mt19937 random{2};
  OwnedCutProblem problem =
      TieRandomly(VoxelGrid::FromCodes(6, BoxCodes({1, 1, 1}, {60, 60, 40})),
                  {.inside = 0},
                  random);
  VoxelWalk walk;
  std::vector<FaceTies> ties = MergeFaceTies(problem.View(), walk, Context(1));
};

size_t NumReached(const FlowState<int32_t>& state) {
  size_t count = 0;
  for (const auto& record : state.SearchRecords()) {
    count += size_t(std::count(record.word, record.word + 3, kReachedNode));
  }
  return count;
}

TEST(SourceSide, IsTheSameInRangesOfAnySize) {
  ReachedBlock block;
  for (const uint32_t range_bricks : {1u, 7u, 100000u}) {
    FlowState<int32_t> state = block.State();
    FloodSourceSide(state, range_bricks, Context(2));
    EXPECT_EQ(NumReached(state), state.NumNodes() - 1) << range_bricks;
  }
}

// In ranges of a brick nearly all is flooded last; or all of it is in one
// range: either flood must stop in the middle. Where it is when it is told to
// is up to the clock; so it is told later and later.
TEST(SourceSide, StopsInTheMiddle) {
  constexpr size_t kNodesOfABrick = 3 * size_t{64};
  ReachedBlock block;
  for (const uint32_t range_bricks : {1u, 100000u}) {
    bool stopped_within = false;
    for (int delay = 0; delay < 200 && !stopped_within; ++delay) {
      FlowState<int32_t> state = block.State();
      std::atomic<bool> cancelled = false;
      std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::microseconds(20 * delay));
        cancelled = true;
      });
      try {
        FloodSourceSide(state, range_bricks, Context(1, nullptr, &cancelled));
      } catch (const CancelledError&) {
        const size_t reached = NumReached(state);
        stopped_within =
            reached > kNodesOfABrick && reached + 1 < state.NumNodes();
      }
      canceller.join();
    }
    EXPECT_TRUE(stopped_within) << range_bricks;
  }
}

}  // namespace
}  // namespace octacut
