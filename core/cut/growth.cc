// Planting the roots, growing the forest, and joining two ranges.
#include <algorithm>
#include <bit>

#include "core/base/error.h"
#include "core/cut/search_forest.h"

namespace octacut {

template <typename Flow>
SearchForest<Flow>::SearchForest(FlowState<Flow>& state,
                                 uint32_t begin,
                                 uint32_t end,
                                 const Context& context)
    : state_(state), context_(context), begin_(begin), end_(end) {
  PlantRoots();
}

template <typename Flow>
void SearchForest<Flow>::PlantRoots() {
  state_.Walk().ForEach(begin_, end_, [&](const VoxelSlot& slot) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const FaceNode node{slot, axis};
      int32_t& word = state_.Word(node);
      if (word == kNoNode || state_.StartsBalanced(node)) {
        continue;
      }
      const int64_t imbalance = state_.Imbalance(node);
      if (imbalance > 0) {
        word = kSourceNode;
        ++num_sources_;
      } else if (imbalance < 0) {
        word = MakeWord(1, kRoot);
        Activate(node);
      }
    }
  });
}

template <typename Flow>
void SearchForest<Flow>::Run() {
  while (num_sources_ > 0 && !active_.Empty()) {
    context_.ThrowIfCancelled();
    Grow();
  }
  if (active_.Empty()) {
    pool_ = ChunkPool();  // all regions together would keep a good deal
  }
}

template <typename Flow>
void SearchForest<Flow>::Grow() {
  const int32_t label = active_.Lowest();
  if (label >= kMaxLabel) {
    throw InvariantError("cut: the search is deeper than any path can be");
  }
  depth_ = std::max(depth_, label + 1);
  active_.Consume(
      label,
      pool_,
      [&](auto axis, NodeId id) { state_.template PrefetchSearch<axis()>(id); },
      [&](auto axis, NodeId id) {
        const AxisNode node = state_.template Node<axis()>(id);
        int32_t& word = state_.Word(node);
        if ((word & kActive) == 0 || Label(word) < label) {
          return;  // a stale entry
        }
        word &= ~kActive;
        if (Label(word) > label) {
          Activate(Untyped(node));
        } else {
          ScanNode(node, label);
        }
      });
  Settle();
}

template <typename Flow>
template <int kAxis>
void SearchForest<Flow>::ScanNode(const AxisNode<kAxis>& node, int32_t label) {
  uint32_t arcs = state_.ResidualIn(node);
  const WordsAround words = state_.Around(node, arcs);
  for (arcs &= ~LowerThan(words, kNoRank); arcs != 0; arcs &= arcs - 1) {
    const int code = std::countr_zero(arcs);
    const FaceNode other = state_.Across(node, code);
    if (!IsSourceNode(words[code]) || TakeExcess(other, node, code)) {
      state_.Word(other) =
          MakeWord(label + 1, kNodeArcs[kAxis][code].back | kActive);
      active_.Add(label + 1, other.axis, IdOf(other.slot), pool_);
    }
  }
}

template <typename Flow>
template <int kAxis>
bool SearchForest<Flow>::TakeExcess(const FaceNode& source,
                                    const AxisNode<kAxis>& node,
                                    int code) {
  const uint32_t voxel = VoxelOf(node, code);
  const uint32_t arc = kNodeArcs[kAxis][code].in;
  const int64_t excess = state_.Imbalance(source);
  const int32_t amount =
      int32_t(std::min<int64_t>(excess, state_.Capacity(voxel, arc)));
  const bool saturated = state_.Push(voxel, arc, amount);
  QueueDrain(Untyped(node));
  if (amount < excess) {
    return false;
  }
  state_.Word(source) = kFreeNode;
  --num_sources_;
  return !saturated;
}
template <typename Flow>
void SearchForest<Flow>::Activate(const FaceNode& node) {
  int32_t& word = state_.Word(node);
  if ((word & kActive) == 0) {
    word |= kActive;
    active_.Add(Label(word), node.axis, IdOf(node.slot), pool_);
  }
}

template <typename Flow>
void SearchForest<Flow>::Absorb(SearchForest& next) {
  const uint32_t middle = end_;
  end_ = next.end_;
  depth_ = std::max(depth_, next.depth_);
  num_sources_ += next.num_sources_;
  active_.Append(std::move(next.active_));
  pool_.Absorb(next.pool_);
  const auto wake_head = [this](const VoxelSlot& slot, uint32_t arc) {
    const FaceNode from = state_.NodeOf(slot, int(arc / 4));
    const FaceNode to = state_.NodeOf(slot, kOctahedron.head[arc]);
    if (Label(state_.Word(to)) > 0 && Label(state_.Word(from)) <= 0) {
      Activate(to);
    }
  };
  // Only bricks of the lower range look across: high faces lead upwards.
  for (uint32_t brick = begin_; brick < middle; ++brick) {
    const auto crosses = [&](int face) {
      const uint32_t beside = state_.Walk().BrickBeside(brick, face);
      return beside >= middle && beside < end_;
    };
    if (crosses(1) || crosses(3) || crosses(5)) {
      state_.Walk().ForEach(brick, brick + 1, [&](const VoxelSlot& slot) {
        for (uint32_t arcs = state_.OpenArcs(slot, end_); arcs != 0;
             arcs &= arcs - 1) {
          wake_head(slot, uint32_t(std::countr_zero(arcs)));
        }
      });
    }
  }
}

template class SearchForest<int32_t>;
template class SearchForest<int16_t>;

}  // namespace octacut
