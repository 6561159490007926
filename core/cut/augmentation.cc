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
    const VoxelPlace low = state_.Low(node);
    if (parent == kOrphan) {
      return 0;
    }
    if (parent == kRoot) {
      path_root_ = node;
      return std::min(supply, state_.Imbalance(node, low));
    }
    const NodeArc& arc = ArcOf(node, parent);
    const uint32_t voxel = VoxelOf(node, low, arc);
    supply = std::min<int64_t>(supply, state_.Capacity(voxel, arc.in));
    path_.push_back({node, voxel, arc.in});
    node = Follow(node, low, arc);
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
  if (state_.Imbalance(path_root_, state_.Low(path_root_)) == 0) {
    MakeOrphan<Forest::kSource>(path_root_);
  }
  QueueDrain(sink_node);
  return saturated;
}

void SearchForest::QueueDrain(const FaceNode& node) {
  int32_t& word = state_.Word(node);
  if ((word & kDraining) == 0) {
    word |= kDraining;
    draining_.Add(Label<Forest::kSink>(word), IdOf(node), pool_);
  }
}

// Moves every excess of the sink forest down as far as it goes.
void SearchForest::Drain() {
  for (int32_t level = draining_.Highest(); level >= 1; --level) {
    draining_.Take(level).Consume(
        pool_,
        [&](NodeId id) { state_.PrefetchFlows(id); },
        [&](NodeId id) { DrainNode(state_.Node(id)); });
  }
  draining_.Lowest();
}

void SearchForest::DrainNode(const FaceNode& node) {
  const VoxelPlace low = state_.Low(node);
  int32_t& word = state_.Word(node);
  word &= ~(kDraining | kExcess);
  const int64_t excess = state_.Imbalance(node, low);
  if (Parent(word) == kRoot) {
    if (excess < 0) {
      return;
    }
    MakeOrphan<Forest::kSink>(node);  // its deficit is filled
  }
  if (excess > 0) {
    SendExcess(node, low, excess);
  }
}

// Pushes to the parent, then to other parents with a lower label, until the
// excess is gone or there is no parent left.
void SearchForest::SendExcess(const FaceNode& node,
                              const VoxelPlace& low,
                              int64_t excess) {
  int32_t& word = state_.Word(node);
  const int32_t label = Label<Forest::kSink>(word);
  int code = Parent(word);
  uint32_t candidates = ArcsToParents<Forest::kSink>(node, low.index);
  if (code == kOrphan) {
    code = FindLowerParent(node, state_.VoxelsAround(node), label, candidates);
  }
  while (code != kOrphan) {
    const NodeArc& arc = ArcOf(node, code);
    const uint32_t voxel = VoxelOf(node, low, arc);
    const int32_t amount =
        int32_t(std::min<int64_t>(excess, state_.Capacity(voxel, arc.out)));
    const bool saturated = state_.Push(voxel, arc.out, amount);
    QueueDrain(Follow(node, low, arc));
    excess -= amount;
    if (!saturated) {
      word = WithParent(word, code);
      return;
    }
    candidates &= ~(1u << code);
    if (excess == 0) {
      break;
    }
    code = FindLowerParent(node, state_.VoxelsAround(node), label, candidates);
  }
  if (Parent(word) != kOrphan) {
    MakeOrphan<Forest::kSink>(node);
  }
  word |= excess > 0 ? kExcess : 0;
}

// Takes candidates off until one is a parent that is itself attached.
int SearchForest::FindLowerParent(const FaceNode& node,
                                  const NodeVoxels& voxels,
                                  int32_t label,
                                  uint32_t& candidates) {
  while (candidates != 0) {
    const int code = std::countr_zero(candidates);
    candidates &= candidates - 1;
    const int32_t word = state_.WordAcross(voxels, node.axis, code);
    const int32_t other = Label<Forest::kSink>(word);
    if (other > 0 && other < label && Parent(word) != kOrphan) {
      return code;
    }
  }
  return kOrphan;
}

}  // namespace octacut
