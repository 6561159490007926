// New parents for the nodes that lost theirs, level by level from below, so
// that a label is settled before a greater one is looked at and every node is
// handled once a label.
#include <algorithm>
#include <bit>

#include "core/cut/search_forest.h"

namespace octacut {

template <typename Flow>
void SearchForest<Flow>::MakeOrphan(const FaceNode& node) {
  int32_t& word = state_.Word(node);
  word = WithParent(word, kOrphan);
  orphans_.Add(Label(word), node.axis, IdOf(node.slot), pool_);
}

template <typename Flow>
void SearchForest<Flow>::Settle() {
  while (!draining_.Empty()) {
    Drain();
    Adopt();
  }
}

template <typename Flow>
void SearchForest<Flow>::Adopt() {
  while (!orphans_.Empty()) {
    const int32_t label = orphans_.Lowest();
    orphans_.Consume(
        label,
        pool_,
        [&](auto axis, NodeId id) {
          state_.template PrefetchSearch<axis()>(id);
        },
        [&](auto axis, NodeId id) {
          const AxisNode node = state_.template Node<axis()>(id);
          const int32_t word = state_.Word(node);
          // Else listed twice, or adopted meanwhile.
          if (Label(word) == label && Parent(word) == kOrphan) {
            AdoptNode(node, label);
          }
        });
  }
}

// A node with a lower label is attached for good when this is asked, since
// all orphans with lower labels have been handled.
template <typename Flow>
template <int kAxis>
void SearchForest<Flow>::AdoptNode(const AxisNode<kAxis>& node, int32_t label) {
  const auto [to_parents, from_children] = state_.ResidualOf(node);
  const uint32_t arcs = to_parents | from_children;
  const WordsAround words = state_.Around(node, arcs);
  const uint32_t lower = LowerThan(words, RankOf(label)) & to_parents;
  if (lower == 0) {
    Lift(node, words, arcs, to_parents);
    return;
  }
  int32_t& word = state_.Word(node);
  word = WithParent(word, std::countr_zero(lower));
  if (label == depth_) {
    Activate(Untyped(node));
  }
  if (word & kExcess) {
    QueueDrain(Untyped(node));
  }
}

// Gives an orphan that has no lower neighbour a greater label. If that is
// beyond the depth it leaves the forest, as a source node if it has an excess.
template <typename Flow>
template <int kAxis>
void SearchForest<Flow>::Lift(const AxisNode<kAxis>& node,
                              const WordsAround& words,
                              uint32_t arcs,
                              uint32_t to_parents) {
  const uint32_t least = words.Least(kRankOffset, to_parents);
  for (uint32_t children =
           words.Matching(kParentMask, kBackCodes[kAxis]) & arcs;
       children != 0;
       children &= children - 1) {
    MakeOrphan(state_.Across(node, std::countr_zero(children)));
  }
  int32_t& word = state_.Word(node);
  if (least < RankOf(depth_)) {
    const int32_t label = LabelOfRank(least) + 1;
    word = MakeWord(label, word & kFlagMask);
    orphans_.Add(label, kAxis, IdOf(node.slot), pool_);
  } else if (word & kExcess) {
    word = kSourceNode;
    ++num_sources_;
  } else {
    word = kFreeNode;
  }
}

template class SearchForest<int32_t>;
template class SearchForest<int16_t>;

}  // namespace octacut
