// Draining what the forest has taken to its roots.
#include <algorithm>
#include <bit>

#include "core/cut/search_forest.h"

namespace octacut {

// Moves every excess of the forest down as far as it goes.
template <typename Flow>
void SearchForest<Flow>::Drain() {
  for (int32_t level = draining_.Highest(); level >= 1; --level) {
    draining_.Consume(
        level,
        pool_,
        [&](auto axis, NodeId id) {
          state_.template PrefetchFlows<axis()>(id);
        },
        [&](auto axis, NodeId id) {
          DrainNode(state_.template Node<axis()>(id));
        });
  }
  draining_.Lowest();
}

template <typename Flow>
template <int kAxis>
void SearchForest<Flow>::DrainNode(const AxisNode<kAxis>& node) {
  int32_t& word = state_.Word(node);
  word &= ~(kDraining | kExcess);
  const int64_t excess = state_.Imbalance(node);
  if (Parent(word) == kRoot) {
    if (excess < 0) {
      return;
    }
    MakeOrphan(Untyped(node));  // its deficit is filled
  }
  if (excess > 0) {
    SendExcess(node, excess);
  }
}

// Pushes to the parent, then to other parents with a lower label, until the
// excess is gone or there is no parent left.
template <typename Flow>
template <int kAxis>
void SearchForest<Flow>::SendExcess(const AxisNode<kAxis>& node,
                                    int64_t excess) {
  int32_t& word = state_.Word(node);
  const auto push = [&](int code) {
    const uint32_t arc = kNodeArcs[kAxis][code].out;
    const uint32_t voxel = VoxelOf(node, code);
    const int32_t amount =
        int32_t(std::min<int64_t>(excess, state_.Capacity(voxel, arc)));
    const bool saturated = state_.Push(voxel, arc, amount);
    QueueDrain(state_.Across(node, code));
    excess -= amount;
    return saturated;
  };
  if (Parent(word) < kRoot) {
    if (!push(Parent(word))) {
      return;
    }
    MakeOrphan(Untyped(node));
  }
  if (excess > 0) {
    uint32_t arcs = state_.ResidualOut(node);
    const WordsAround words = state_.Around(node, arcs);
    const uint32_t below = RankOf(Label(word));
    // Nothing may be pushed along an arc once nothing is left.
    for (; arcs != 0 && excess > 0; arcs &= arcs - 1) {
      const int code = std::countr_zero(arcs);
      if (Rank(words[code]) < below && Parent(words[code]) != kOrphan &&
          !push(code)) {
        word = WithParent(word, code);
        return;
      }
    }
    word |= excess > 0 ? kExcess : 0;
  }
}

template class SearchForest<int32_t>;
template class SearchForest<int16_t>;

}  // namespace octacut
