// New parents for the nodes that lost theirs, level by level from below, so
// that a label is settled before a greater one is looked at and every node is
// handled once a label.
#include <bit>
#include <limits>

#include "core/cut/search_forest.h"

namespace octacut {

template <Forest F>
void SearchForest::MakeOrphan(const FaceNode& node) {
  int32_t& word = state_.Word(node);
  word = WithParent(word, kOrphan);
  orphans_[int(F)].Add(Label<F>(word), IdOf(node), pool_);
}
template void SearchForest::MakeOrphan<Forest::kSource>(const FaceNode&);
template void SearchForest::MakeOrphan<Forest::kSink>(const FaceNode&);

void SearchForest::Settle() {
  if (!unsettled_) {
    return;
  }
  unsettled_ = false;
  Adopt<Forest::kSource>();
  while (!draining_.Empty()) {
    Drain();
    Adopt<Forest::kSink>();
  }
}

template <Forest F>
void SearchForest::Adopt() {
  BucketQueue& orphans = orphans_[int(F)];
  while (!orphans.Empty()) {
    const int32_t label = orphans.Lowest();
    orphans.Take(label).Consume(
        pool_,
        [&](NodeId id) { state_.PrefetchSearch(id); },
        [&](NodeId id) { AdoptNode<F>(id, label); });
  }
}

// A node with a lower label is attached for good when this is asked, since
// all orphans with lower labels have been handled.
template <Forest F>
void SearchForest::AdoptNode(NodeId id, int32_t label) {
  const FaceNode node = state_.Node(id);
  int32_t& word = state_.Word(node);
  if (Label<F>(word) != label || Parent(word) != kOrphan) {
    return;  // listed twice, or adopted meanwhile
  }
  const NodeVoxels voxels = state_.VoxelsAround(node);
  int32_t least = std::numeric_limits<int32_t>::max();
  for (uint32_t arcs = ArcsToParents<F>(node, voxels.index[1]); arcs != 0;
       arcs &= arcs - 1) {
    const int code = std::countr_zero(arcs);
    const int32_t other = Label<F>(state_.WordAcross(voxels, node.axis, code));
    if (other <= 0) {
      continue;
    }
    if (other < label) {
      word = WithParent(word, code);
      if (label == Depth(F)) {
        Activate<F>(node);
      }
      if (word & kExcess) {
        QueueDrain(node);
      }
      return;
    }
    least = std::min(least, other);
  }
  OrphanChildren<F>(node, voxels, label);
  if (least < Depth(F)) {
    word = MakeWord<F>(least + 1, word & kFlagMask);
    orphans_[int(F)].Add(least + 1, id, pool_);
  } else {
    Leave<F>(node);
  }
}

template <Forest F>
void SearchForest::OrphanChildren(const FaceNode& node,
                                  const NodeVoxels& voxels,
                                  int32_t label) {
  for (uint32_t arcs = ArcsAway<F>(node, voxels.index[1]); arcs != 0;
       arcs &= arcs - 1) {
    const int code = std::countr_zero(arcs);
    const int32_t word = state_.WordAcross(voxels, node.axis, code);
    const NodeArc& arc = ArcOf(node, code);
    if (Label<F>(word) > label && Parent(word) == arc.back) {
      MakeOrphan<F>(Follow(node, state_.Low(node), arc));
    }
  }
}

// A node without a parent below the frontier leaves the forest. An excess
// that the sink forest cannot take starts a tree of the source forest.
template <Forest F>
void SearchForest::Leave(const FaceNode& node) {
  int32_t& word = state_.Word(node);
  if (word & kExcess) {
    word = MakeWord<Forest::kSource>(Depth(Forest::kSource), kRoot);
    Activate<Forest::kSource>(node);
  } else {
    word = 0;
  }
}

}  // namespace octacut
