// What a run sees of a cut while it works, and stopping it.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "core/base/error.h"
#include "tests/core/cut/cut_test_problems.h"

namespace octacut {
namespace {

// A block large enough for several regions.
OwnedCutProblem Block() {
  std::mt19937 random(2);
  OwnedCutProblem problem =
      TieRandomly(VoxelGrid::FromCodes(6, BoxCodes({1, 1, 1}, {60, 60, 40})),
                  {.inside = 0.4},
                  random);
  SetRandomWeights(WeightKind::kSpeckle, random, problem);
  return problem;
}

class Recorder : public ProgressSink {
 public:
  // Sets `cancelled` once a phase has advanced.
  explicit Recorder(std::atomic<bool>* cancelled = nullptr)
      : cancelled_(cancelled) {}
  void BeginPhase(std::string_view name, size_t total) override {
    names.emplace_back(name);
    totals.push_back(total);
    steps.emplace_back();
  }
  void Advance(size_t done) override {
    steps.back().push_back(done);
    if (cancelled_ != nullptr) {
      *cancelled_ = true;
    }
  }
  void EndPhase() override { ++num_ended; }
  void Info(std::string_view) override {}
  void Warn(std::string_view) override {}

  std::vector<std::string> names;
  std::vector<size_t> totals;
  std::vector<std::vector<size_t>> steps;  // of each phase
  int num_ended = 0;

 private:
  std::atomic<bool>* cancelled_;
};

TEST(CutProgress, EndsAtWhatWasEstimated) {
  const OwnedCutProblem problem = Block();
  Recorder recorder;
  SolveOctahedralCut(problem.View(), {}, Context(1, &recorder));
  ASSERT_EQ(recorder.names, std::vector<std::string>{"minimum cut"});
  EXPECT_EQ(recorder.num_ended, 1);
  // At least four regions and their joins.
  ASSERT_GE(recorder.steps[0].size(), 7u);
  EXPECT_TRUE(std::is_sorted(recorder.steps[0].begin(),
                             recorder.steps[0].end(),
                             std::less_equal<size_t>()));
  EXPECT_EQ(recorder.steps[0].back(), recorder.totals[0]);
  EXPECT_GE(recorder.totals[0], problem.crust.Size());
}

TEST(CutProgress, ACrustThatHasGrownIsAPhaseOfItsOwn) {
  const OwnedCutProblem problem = Block();
  Recorder recorder;
  OctahedralCutState state;
  for (int round = 0; round < 2; ++round) {
    SolveOctahedralCut(problem.View(), {}, Context(1, &recorder), &state);
  }
  ASSERT_EQ(recorder.names.size(), 2u);
  EXPECT_EQ(recorder.names[1], "minimum cut of the grown crust");
}

TEST(CutProgress, StopsInTheMiddle) {
  const OwnedCutProblem problem = Block();
  for (const int num_threads : {1, 2}) {
    std::atomic<bool> cancelled = false;
    Recorder recorder(&cancelled);
    EXPECT_THROW(
        SolveOctahedralCut(
            problem.View(), {}, Context(num_threads, &recorder, &cancelled)),
        CancelledError);
    ASSERT_EQ(recorder.steps.size(), 1u);
    EXPECT_LT(recorder.steps[0].back(), recorder.totals[0]);
  }
}

}  // namespace
}  // namespace octacut
