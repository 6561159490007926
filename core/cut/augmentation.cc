// Sending flow from the source forest to the sink forest.
#include <algorithm>
#include <bit>
#include <limits>

#include "core/cut/search_forest.h"

namespace octacut {

// What can flow down from the root of a source node's tree; fills path_.
int64_t SearchForest::TraceSupply(FaceNode node) {
  path_.clear();
  int64_t supply = std::numeric_limits<int64_t>::max();
  for (;;) {
    const int32_t parent = Parent(state_.Word(node));
    if (parent == kOrphan) {
      return 0;
    }
    if (parent == kRoot) {
      path_root_ = node;
      return std::min(supply, state_.Imbalance(node));
    }
    const NodeArc& arc = kNodeArcs[node.axis][parent];
    const VoxelPlace holder = arc.side ? state_.Low(node) : node.place;
    supply = std::min<int64_t>(supply, state_.Capacity(holder.index, arc.in));
    path_.push_back({node, holder.index, arc.in});
    node = {state_.Walk().Step(holder, arc.step), arc.axis};
  }
}

bool SearchForest::Augment(const FaceNode& source_node,
                           const FaceNode& sink_node,
                           uint32_t voxel,
                           uint32_t arc) {
  unsettled_ = true;
  const int64_t supply = TraceSupply(source_node);
  if (supply <= 0) {
    return false;
  }
  const int32_t amount =
      int32_t(std::min<int64_t>(supply, state_.Capacity(voxel, arc)));
  const bool saturated = state_.Push(voxel, arc, amount);
  for (const PathStep& step : path_) {
    if (state_.Push(step.voxel, step.arc, amount)) {
      MakeOrphan<Forest::kSource>(step.child);
    }
  }
  if (state_.Imbalance(path_root_) == 0) {
    MakeOrphan<Forest::kSource>(path_root_);
  }
  QueueDrain(sink_node);
  return saturated;
}

void SearchForest::QueueDrain(const FaceNode& node) {
  int32_t& word = state_.Word(node);
  if ((word & kDraining) == 0) {
    word |= kDraining;
    draining_.Add(
        Label<Forest::kSink>(word), node.axis, IdOf(node.place), pool_);
  }
}

// Moves every excess of the sink forest down as far as it goes.
void SearchForest::Drain() {
  for (int32_t level = draining_.Highest(); level >= 1; --level) {
    draining_.Consume(
        level,
        pool_,
        [&](auto axis, NodeId id) { state_.PrefetchFlows<axis()>(id); },
        [&](auto axis, NodeId id) { DrainNode(state_.Node<axis()>(id)); });
  }
  draining_.Lowest();
}

template <int kAxis>
void SearchForest::DrainNode(const AxisNode<kAxis>& node) {
  int32_t& word = state_.Word(node);
  word &= ~(kDraining | kExcess);
  const int64_t excess = state_.Imbalance(node);
  if (Parent(word) == kRoot) {
    if (excess < 0) {
      return;
    }
    MakeOrphan<Forest::kSink>(Untyped(node));  // its deficit is filled
  }
  if (excess > 0) {
    SendExcess(node, excess);
  }
}

// Pushes to the parent, then to other parents with a lower label, until the
// excess is gone or there is no parent left.
template <int kAxis>
void SearchForest::SendExcess(const AxisNode<kAxis>& node, int64_t excess) {
  int32_t& word = state_.Word(node);
  const auto push = [&](int code) {
    const NodeArc& arc = kNodeArcs[kAxis][code];
    const uint32_t voxel = VoxelOf(node, code);
    const int32_t amount =
        int32_t(std::min<int64_t>(excess, state_.Capacity(voxel, arc.out)));
    const bool saturated = state_.Push(voxel, arc.out, amount);
    QueueDrain(state_.Across(node, code));
    excess -= amount;
    return saturated;
  };
  if (Parent(word) < kRoot) {
    if (!push(Parent(word))) {
      return;
    }
    MakeOrphan<Forest::kSink>(Untyped(node));
  }
  if (excess > 0) {
    uint32_t arcs = ArcsToParents<Forest::kSink>(node);
    const WordsAround words = state_.Around(node, arcs);
    const uint32_t below = RankOf(Label<Forest::kSink>(word));
    for (; arcs != 0 && excess > 0; arcs &= arcs - 1) {
      const int code = std::countr_zero(arcs);
      if (Rank<Forest::kSink>(words[code]) < below &&
          Parent(words[code]) != kOrphan && !push(code)) {
        word = WithParent(word, code);
        return;
      }
    }
    word |= excess > 0 ? kExcess : 0;
  }
}

}  // namespace octacut
