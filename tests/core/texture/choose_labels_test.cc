#include "core/texture/choose_labels.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/hash.h"

namespace octacut {
namespace {

constexpr uint32_t kLabels = 3;

// A grid of width x height nodes with random costs; node n may have the labels
// of which its random mask has a bit.
LabelingProblem RandomGrid(uint32_t width, uint32_t height, uint64_t seed) {
  LabelingProblem problem;
  for (uint32_t n = 0; n < width * height; ++n) {
    for (uint32_t label = 0; label < kLabels; ++label) {
      const uint64_t bits = HashBits(seed, n, label);
      if (label == n % kLabels || HashUniform(bits) < 0.8) {
        problem.choices.push_back({label, float(HashUniform(bits + 1))});
      }
    }
    problem.first.push_back(uint32_t(problem.choices.size()));
    const auto weight = [&](uint64_t k) {
      return 0.5f * float(HashUniform(HashBits(seed, n, 100 + k)));
    };
    if (n % width > 0) {
      problem.edges.push_back({n - 1, n, weight(0)});
    }
    if (n >= width) {
      problem.edges.push_back({n - width, n, weight(1)});
    }
  }
  return problem;
}

bool IsAllowed(const LabelingProblem& problem,
               const std::vector<uint32_t>& labels) {
  for (size_t n = 0; n < labels.size(); ++n) {
    bool found = false;
    for (const LabelingProblem::Choice& choice : problem.ChoicesOf(n)) {
      found = found || choice.label == labels[n];
    }
    if (!found) {
      return false;
    }
  }
  return true;
}

double LeastEnergy(const LabelingProblem& problem) {
  std::vector<uint32_t> labels(problem.NumNodes(), 0);
  double least = std::numeric_limits<double>::infinity();
  while (true) {
    if (IsAllowed(problem, labels)) {
      least = std::min(least, LabelingEnergy(problem, labels));
    }
    size_t n = 0;
    while (n < labels.size() && ++labels[n] == kLabels) {
      labels[n++] = 0;
    }
    if (n == labels.size()) {
      return least;
    }
  }
}

// Every labelling of ten nodes is tried.
TEST(ChooseLabels, ComesWithinTwoPercentOfTheMinimum) {
  double found = 0;
  double least = 0;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const LabelingProblem problem = RandomGrid(5, 2, seed);
    const std::vector<uint32_t> labels = ChooseLabels(problem, Context(1));
    ASSERT_TRUE(IsAllowed(problem, labels));
    const double minimum = LeastEnergy(problem);
    EXPECT_LE(LabelingEnergy(problem, labels), 1.1 * minimum);
    found += LabelingEnergy(problem, labels);
    least += minimum;
  }
  EXPECT_GE(found, least - 1e-5);
  EXPECT_LE(found, 1.02 * least);
}

// Two nodes of opposite wishes follow the dearer one; alone, each its own.
TEST(ChooseLabels, WeighsEdgesAgainstCosts) {
  LabelingProblem problem;
  problem.choices = {{0, 0}, {1, 1}, {0, 3}, {1, 0}};
  problem.first = {0, 2, 4};
  EXPECT_EQ(ChooseLabels(problem, Context(1)), (std::vector<uint32_t>{0, 1}));
  problem.edges = {{0, 1, 2}};
  EXPECT_EQ(ChooseLabels(problem, Context(1)), (std::vector<uint32_t>{1, 1}));
}

// Many expansions of a large grid: no worse than any single label, and the
// local minimum that alpha-expansion promises is below twice the best bound.
TEST(ChooseLabels, ImprovesOnLargeGrids) {
  const LabelingProblem problem = RandomGrid(40, 40, 7);
  std::vector<uint32_t> greedy;
  double bound = 0;
  for (size_t n = 0; n < problem.NumNodes(); ++n) {
    const auto choices = problem.ChoicesOf(n);
    const auto* least = &choices[0];
    for (const auto& choice : choices) {
      least = choice.cost < least->cost ? &choice : least;
    }
    greedy.push_back(least->label);
    bound += double(least->cost);
  }
  const double energy =
      LabelingEnergy(problem, ChooseLabels(problem, Context(1)));
  EXPECT_GE(energy, bound);
  EXPECT_LT(energy, 0.9 * LabelingEnergy(problem, greedy));
}

}  // namespace
}  // namespace octacut
