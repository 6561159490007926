// Labels for the nodes of a graph: costs of nodes and a Potts model on edges,
// minimized by alpha-expansion.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/context.h"

namespace octacut {

struct LabelingProblem {
  struct Choice {
    uint32_t label;
    float cost;
  };
  struct Edge {
    uint32_t a, b;  // nodes
    float weight;   // cost of different labels; not negative
  };

  // The choices of node n are choices[first[n]] .. choices[first[n + 1] - 1];
  // at least one.
  std::vector<uint32_t> first = {0};
  std::vector<Choice> choices;
  std::vector<Edge> edges;

  size_t NumNodes() const { return first.size() - 1; }
  std::span<const Choice> ChoicesOf(size_t node) const {
    return {choices.data() + first[node], first[node + 1] - first[node]};
  }
};

double LabelingEnergy(const LabelingProblem& problem,
                      const std::vector<uint32_t>& labels);

// Alpha-expansion (Y. Boykov, O. Veksler and R. Zabih, "Fast Approximate Energy
// Minimization via Graph Cuts", PAMI 2001) from the labels of least cost, until
// a round of expansions gains less than a thousandth. Only nodes that may have
// a label take part in its expansion, and labels are left out while nothing has
// changed where they may be.
std::vector<uint32_t> ChooseLabels(const LabelingProblem& problem,
                                   const Context& context);

}  // namespace octacut
