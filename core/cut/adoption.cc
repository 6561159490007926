// New parents for the nodes that lost theirs, level by level from below, so
// that a label is settled before a greater one is looked at and every node is
// handled once a label.
#include <algorithm>
#include <bit>

#include "core/cut/search_forest.h"

namespace octacut {

template <Forest F>
void SearchForest::MakeOrphan(const FaceNode& node) {
  int32_t& word = state_.Word(node);
  word = WithParent(word, kOrphan);
  orphans_[int(F)].Add(Label<F>(word), node.axis, IdOf(node.place), pool_);
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
    orphans.Consume(
        label,
        pool_,
        [&](auto axis, NodeId id) { state_.PrefetchSearch<axis()>(id); },
        [&](auto axis, NodeId id) {
          const AxisNode node = state_.Node<axis()>(id);
          const int32_t word = state_.Word(node);
          // Else listed twice, or adopted meanwhile.
          if (Label<F>(word) == label && Parent(word) == kOrphan) {
            AdoptNode<F>(node, label);
          }
        });
  }
}

// A node with a lower label is attached for good when this is asked, since
// all orphans with lower labels have been handled.
template <Forest F, int kAxis>
void SearchForest::AdoptNode(const AxisNode<kAxis>& node, int32_t label) {
  const uint32_t to_parents = ArcsToParents<F>(node);
  const uint32_t arcs = to_parents | ArcsAway<F>(node);
  const WordsAround words = state_.Around(node, arcs);
  uint32_t lower = 0;
  for (int code = kNumNodeArcs - 1; code >= 0; --code) {
    lower += lower + (Rank<F>(words[code]) < RankOf(label));
  }
  lower &= to_parents;
  if (lower == 0) {
    Lift<F>(node, words, arcs, to_parents);
    return;
  }
  int32_t& word = state_.Word(node);
  word = WithParent(word, std::countr_zero(lower));
  if (label == Depth(F)) {
    Activate<F>(Untyped(node));
  }
  if (word & kExcess) {
    QueueDrain(Untyped(node));
  }
}

// Gives an orphan that has no lower neighbour a greater label.
template <Forest F, int kAxis>
void SearchForest::Lift(const AxisNode<kAxis>& node,
                        const WordsAround& words,
                        uint32_t arcs,
                        uint32_t to_parents) {
  uint32_t children = 0;
  uint32_t least = kNoRank;
  for (int code = kNumNodeArcs - 1; code >= 0; --code) {
    children += children + IsChild<F>(words[code], kNodeArcs[kAxis][code].back);
    least = std::min(least,
                     Rank<F>(words[code]) | (((to_parents >> code) & 1) - 1));
  }
  for (children &= arcs; children != 0; children &= children - 1) {
    MakeOrphan<F>(state_.Across(node, std::countr_zero(children)));
  }
  if (least < RankOf(Depth(F))) {
    int32_t& word = state_.Word(node);
    const int32_t label = LabelOfRank(least) + 1;
    word = MakeWord<F>(label, word & kFlagMask);
    orphans_[int(F)].Add(label, kAxis, IdOf(node.place), pool_);
  } else {
    Leave<F>(Untyped(node));
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
    word = FlowState::kFreeNode;
  }
}

}  // namespace octacut
