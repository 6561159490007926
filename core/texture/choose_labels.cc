#include "core/texture/choose_labels.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

namespace octacut {
namespace {

constexpr int kNotActive = -1;
// Rounds that gain less than this share of the energy are the last: expansions
// end within a few percent of the minimum anyway.
constexpr double kLeastGain = 1e-3;
// Expansions seldom need more than four.
constexpr int kMaxRounds = 20;

class Expander {
 public:
  Expander(const LabelingProblem& problem, const Context& context)
      : problem_(problem), context_(context) {
    const size_t num_nodes = problem.NumNodes();
    labels_.resize(num_nodes);
    nodes_.assign(num_nodes, kNotActive);
    for (size_t n = 0; n < num_nodes; ++n) {
      const auto choices = problem.ChoicesOf(n);
      labels_[n] = std::min_element(choices.begin(),
                                    choices.end(),
                                    [](const auto& a, const auto& b) {
                                      return a.cost < b.cost;
                                    })
                       ->label;
      for (const LabelingProblem::Choice& choice : choices) {
        num_labels_ = std::max(num_labels_, choice.label + 1);
      }
    }
    CollectNodes();
    CollectEdges();
  }

  std::vector<uint32_t> Run() {
    std::vector<uint8_t> is_open(num_labels_, 1);
    Phase phase(context_, "choice of views");
    double energy = LabelingEnergy(problem_, labels_);
    for (int round = 0; round < kMaxRounds; ++round) {
      bool changed = false;
      for (uint32_t label = 0; label < num_labels_; ++label) {
        context_.ThrowIfCancelled();
        if (!is_open[label]) {
          continue;
        }
        is_open[label] = 0;
        if (Expand(label, &is_open)) {
          changed = true;
        }
        phase.Advance();
      }
      const double before = energy;
      energy = LabelingEnergy(problem_, labels_);
      if (!changed || before - energy < kLeastGain * energy) {
        break;
      }
    }
    return std::move(labels_);
  }

 private:
  struct NodeOfLabel {
    uint32_t node;
    float cost;
  };

  void CollectNodes() {
    first_of_label_.assign(num_labels_ + 1, 0);
    for (const LabelingProblem::Choice& choice : problem_.choices) {
      ++first_of_label_[choice.label + 1];
    }
    for (uint32_t l = 0; l < num_labels_; ++l) {
      first_of_label_[l + 1] += first_of_label_[l];
    }
    std::vector<size_t> next(first_of_label_.begin(),
                             first_of_label_.end() - 1);
    nodes_of_label_.resize(problem_.choices.size());
    for (size_t n = 0; n < problem_.NumNodes(); ++n) {
      for (const LabelingProblem::Choice& choice : problem_.ChoicesOf(n)) {
        nodes_of_label_[next[choice.label]++] = {uint32_t(n), choice.cost};
      }
    }
  }

  void CollectEdges() {
    first_edge_.assign(problem_.NumNodes() + 1, 0);
    for (const LabelingProblem::Edge& edge : problem_.edges) {
      ++first_edge_[edge.a + 1];
      ++first_edge_[edge.b + 1];
    }
    for (size_t n = 0; n < problem_.NumNodes(); ++n) {
      first_edge_[n + 1] += first_edge_[n];
    }
    std::vector<size_t> next(first_edge_.begin(), first_edge_.end() - 1);
    edges_of_node_.resize(2 * problem_.edges.size());
    for (size_t e = 0; e < problem_.edges.size(); ++e) {
      edges_of_node_[next[problem_.edges[e].a]++] = uint32_t(e);
      edges_of_node_[next[problem_.edges[e].b]++] = uint32_t(e);
    }
  }

  float CostOf(uint32_t node, uint32_t label) const {
    for (const LabelingProblem::Choice& choice : problem_.ChoicesOf(node)) {
      if (choice.label == label) {
        return choice.cost;
      }
    }
    return 0;  // not reached: nodes have one of their labels
  }

  bool Expand(uint32_t label, std::vector<uint8_t>* is_open) {
    active_.clear();
    for (size_t i = first_of_label_[label]; i < first_of_label_[label + 1];
         ++i) {
      const NodeOfLabel& candidate = nodes_of_label_[i];
      if (labels_[candidate.node] != label) {
        nodes_[candidate.node] = int(active_.size());
        active_.push_back(candidate);
      }
    }
    if (active_.empty()) {
      return false;
    }
    graph_ = {};  // create() alone keeps the nodes of the last expansion
    graph_.create(unsigned(active_.size()), unsigned(4 * active_.size()));
    for (size_t i = 0; i < active_.size(); ++i) {
      graph_.addVtx();
    }
    // A graph without any edge is refused.
    graph_.addEdges(0, graph_.addVtx(), 0, 0);
    for (size_t i = 0; i < active_.size(); ++i) {
      AddNode(int(i), label);
    }
    graph_.maxFlow();
    bool changed = false;
    for (size_t i = 0; i < active_.size(); ++i) {
      // The side of the sink takes the label.
      if (!graph_.inSourceSegment(int(i))) {
        changed = true;
        labels_[active_[i].node] = label;
        OpenAround(active_[i].node, label, is_open);
      }
    }
    for (const NodeOfLabel& node : active_) {
      nodes_[node.node] = kNotActive;
    }
    return changed;
  }

  // Terms of a node and of its edges; edges between active nodes are added by
  // the one with the lower number.
  void AddNode(int i, uint32_t label) {
    const uint32_t node = active_[size_t(i)].node;
    // Cut from the sink where it keeps its label, from the source where it
    // takes the new one.
    double keep = CostOf(node, labels_[node]);
    double take = active_[size_t(i)].cost;
    for (size_t k = first_edge_[node]; k < first_edge_[node + 1]; ++k) {
      const LabelingProblem::Edge& edge = problem_.edges[edges_of_node_[k]];
      const uint32_t other = edge.a == node ? edge.b : edge.a;
      const int j = nodes_[other];
      const double weight = edge.weight;
      if (j == kNotActive) {
        keep += labels_[other] != labels_[node] ? weight : 0;
        take += labels_[other] != label ? weight : 0;
      } else if (j > i && labels_[node] == labels_[other]) {
        graph_.addEdges(i, j, weight, weight);
      } else if (j > i) {
        // Weight unless both take it: w x_i' + w (x_i = take, x_j = keep).
        keep += weight;
        graph_.addEdges(j, i, weight, 0);
      }
    }
    const double common = std::min(keep, take);
    graph_.addTermWeights(i, take - common, keep - common);
  }

  void OpenAround(uint32_t node,
                  uint32_t label,
                  std::vector<uint8_t>* is_open) const {
    const auto open = [&](uint32_t n) {
      for (const LabelingProblem::Choice& choice : problem_.ChoicesOf(n)) {
        if (choice.label != label) {
          (*is_open)[choice.label] = 1;
        }
      }
    };
    open(node);
    for (size_t k = first_edge_[node]; k < first_edge_[node + 1]; ++k) {
      const LabelingProblem::Edge& edge = problem_.edges[edges_of_node_[k]];
      open(edge.a == node ? edge.b : edge.a);
    }
  }

  const LabelingProblem& problem_;
  const Context& context_;
  uint32_t num_labels_ = 0;
  std::vector<uint32_t> labels_;
  std::vector<size_t> first_of_label_;
  std::vector<NodeOfLabel> nodes_of_label_;
  std::vector<size_t> first_edge_;
  std::vector<uint32_t> edges_of_node_;
  std::vector<NodeOfLabel> active_;
  std::vector<int> nodes_;  // in active_, or kNotActive
  cv::detail::GCGraph<double> graph_;
};

}  // namespace

double LabelingEnergy(const LabelingProblem& problem,
                      const std::vector<uint32_t>& labels) {
  double energy = 0;
  for (size_t n = 0; n < problem.NumNodes(); ++n) {
    for (const LabelingProblem::Choice& choice : problem.ChoicesOf(n)) {
      energy += choice.label == labels[n] ? double(choice.cost) : 0.0;
    }
  }
  for (const LabelingProblem::Edge& edge : problem.edges) {
    energy += labels[edge.a] != labels[edge.b] ? double(edge.weight) : 0.0;
  }
  return energy;
}

std::vector<uint32_t> ChooseLabels(const LabelingProblem& problem,
                                   const Context& context) {
  if (problem.NumNodes() == 0) {
    return {};
  }
  return Expander(problem, context).Run();
}

}  // namespace octacut
