// Planting the roots, growing the forest, and joining two ranges.
#include <algorithm>
#include <bit>

#include "core/base/error.h"
#include "core/cut/search_forest.h"

namespace octacut {

SearchForest::SearchForest(FlowState& state,
                           uint32_t begin,
                           uint32_t end,
                           const Context& context)
    : state_(state), context_(context), begin_(begin), end_(end) {
  PlantRoots();
}

void SearchForest::PlantRoots() {
  state_.Walk().ForEach(begin_, end_, [&](const VoxelPlace& place) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const FaceNode node{place, axis};
      int32_t& word = state_.Word(node);
      if (word == FlowState::kNoNode || state_.StartsBalanced(node)) {
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

void SearchForest::Run() {
  while (num_sources_ > 0 && !active_.Empty()) {
    context_.ThrowIfCancelled();
    Grow();
  }
  if (active_.Empty()) {
    pool_ = ChunkPool();  // all regions together would keep a good deal
  }
}

void SearchForest::Grow() {
  const int32_t label = active_.Lowest();
  if (label >= kMaxLabel) {
    throw InvariantError("cut: the search is deeper than any path can be");
  }
  depth_ = std::max(depth_, label + 1);
  active_.Consume(
      label,
      pool_,
      [&](auto axis, NodeId id) { state_.PrefetchSearch<axis()>(id); },
      [&](auto axis, NodeId id) {
        const AxisNode node = state_.Node<axis()>(id);
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

template <int kAxis>
void SearchForest::ScanNode(const AxisNode<kAxis>& node, int32_t label) {
  uint32_t arcs = state_.ResidualIn(node);
  const WordsAround words = state_.Around(node, arcs);
  uint32_t joined = 0;
  for (int code = kNumNodeArcs - 1; code >= 0; --code) {
    joined += joined + (Rank(words[code]) < kNoRank);
  }
  for (arcs &= ~joined; arcs != 0; arcs &= arcs - 1) {
    const int code = std::countr_zero(arcs);
    const FaceNode other = state_.Across(node, code);
    if (!IsSource(words[code]) || TakeExcess(other, node, code)) {
      state_.Word(other) = MakeWord(label + 1, kNodeArcs[kAxis][code].back);
      Activate(other);
    }
  }
}

void SearchForest::Activate(const FaceNode& node) {
  int32_t& word = state_.Word(node);
  if ((word & kActive) == 0) {
    word |= kActive;
    active_.Add(Label(word), node.axis, IdOf(node.place), pool_);
  }
}

void SearchForest::Absorb(SearchForest& next) {
  const uint32_t middle = end_;
  end_ = next.end_;
  depth_ = std::max(depth_, next.depth_);
  num_sources_ += next.num_sources_;
  active_.Append(std::move(next.active_));
  pool_.Absorb(next.pool_);
  const auto wake_head = [this](const VoxelPlace& place, uint32_t arc) {
    const FaceNode from = state_.NodeOf(place, int(arc / 4));
    const FaceNode to = state_.NodeOf(place, kOctahedron.head[arc]);
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
      state_.Walk().ForEach(brick, brick + 1, [&](const VoxelPlace& place) {
        state_.OpenArcs(
            place, end_, [&](uint32_t arc) { wake_head(place, arc); });
      });
    }
  }
}

void SearchForest::Finish() {
  if (num_sources_ == 0) {
    return;
  }
  constexpr int32_t kLevel = 1;
  const auto flood = [&] {
    while (!active_.Empty()) {
      active_.Consume(
          kLevel,
          pool_,
          [&](auto axis, NodeId id) { state_.PrefetchSearch<axis()>(id); },
          [&](auto axis, NodeId id) { FloodNode(state_.Node<axis()>(id)); });
    }
  };
  // A few bricks at a time, so that the queue stays short.
  constexpr uint32_t kBricks = 256;
  for (uint32_t begin = begin_; begin < end_; begin += kBricks) {
    context_.ThrowIfCancelled();
    const uint32_t end = std::min(end_, begin + kBricks);
    state_.Walk().ForEach(begin, end, [&](const VoxelPlace& place) {
      for (uint32_t axis = 0; axis < 3; ++axis) {
        if (state_.Word({place, axis}) == kSourceNode) {
          active_.Add(kLevel, axis, IdOf(place), pool_);
        }
      }
    });
    flood();
  }
}

// Those that are reached are told apart from those that are to be scanned.
template <int kAxis>
void SearchForest::FloodNode(const AxisNode<kAxis>& node) {
  uint32_t arcs = state_.ResidualOut(node);
  const WordsAround words = state_.Around(node, arcs);
  for (; arcs != 0; arcs &= arcs - 1) {
    const int code = std::countr_zero(arcs);
    if (words[code] == FlowState::kFreeNode) {
      const FaceNode other = state_.Across(node, code);
      state_.Word(other) = kSourceNode | kActive;
      active_.Add(1, other.axis, IdOf(other.place), pool_);
    }
  }
}

}  // namespace octacut
