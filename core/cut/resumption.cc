// Taking up a search that had ended, after its crust has grown.
#include <algorithm>
#include <utility>
#include <vector>

#include "core/cut/search_forest.h"

namespace octacut {
namespace {

constexpr uint32_t kNeighborhoodVoxels = 1 << 15;

}  // namespace

template <typename Flow>
SearchForest<Flow>::SearchForest(FlowState<Flow>& state,
                                 std::span<const NodeId> changed,
                                 const Context& context)
    : state_(state),
      context_(context),
      begin_(0),
      end_(uint32_t(state.Walk().NumBricks())) {
  RecoverForest();
  for (const NodeId voxel : changed) {
    const VoxelSlot slot = state_.Walk().At(voxel >> 6, voxel & 63);
    for (int face = 0; face < kNumFaces; ++face) {
      if (((state_.Residual(slot.index) >> (kNumOctahedronArcs + face)) & 1) ==
          0) {
        const FaceNode node = state_.NodeOf(slot, face);
        switch (node.axis) {
          case 0:
            Reconsider(state_.template NodeAt<0>(node.slot));
            break;
          case 1:
            Reconsider(state_.template NodeAt<1>(node.slot));
            break;
          default:
            Reconsider(state_.template NodeAt<2>(node.slot));
        }
      }
    }
  }
  // Excesses first: an orphan that cannot stay must know of its own.
  Drain();
  Adopt();
  Settle();
}

// What has changed lies scattered over the crust: each neighbourhood is
// searched to its end before the next, while its voxels are in the cache.
template <typename Flow>
void SearchForest<Flow>::RunByNeighborhood() {
  std::vector<FaceNode> waiting;
  while (!active_.Empty()) {
    active_.Consume(
        active_.Lowest(),
        pool_,
        [](auto, NodeId) {},
        [&](auto axis, NodeId id) {
          waiting.push_back(Untyped(state_.template Node<axis()>(id)));
        });
  }
  std::sort(waiting.begin(), waiting.end(), [](const auto& a, const auto& b) {
    return std::pair(a.slot.index, a.axis) < std::pair(b.slot.index, b.axis);
  });
  for (size_t k = 0; k < waiting.size();) {
    const uint32_t neighborhood = waiting[k].slot.index / kNeighborhoodVoxels;
    for (; k < waiting.size() &&
           waiting[k].slot.index / kNeighborhoodVoxels == neighborhood;
         ++k) {
      // Unless it was scanned meanwhile, it is active but in no list.
      int32_t& word = state_.Word(waiting[k]);
      if (word > 0 && (word & kActive)) {
        word &= ~kActive;
        Activate(waiting[k]);
      }
    }
    Run();
  }
}

// The lists and the depth, from the words alone. What the last search only
// reached from its source nodes is free.
template <typename Flow>
void SearchForest<Flow>::RecoverForest() {
  state_.Walk().ForEach(begin_, end_, [&](const VoxelSlot& slot) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const FaceNode node{slot, axis};
      int32_t& word = state_.Word(node);
      if (word == kSourceNode) {
        ++num_sources_;
      } else if (IsSourceNode(word)) {
        word = kFreeNode;
      } else if (Label(word) > 0) {
        // All labels stay below the depth.
        depth_ = std::max(depth_, Label(word) + 1);
        if (word & kActive) {
          word &= ~kActive;
          Activate(node);
        }
      }
    }
  });
}

// Sets right the word of a node whose arcs or imbalance may have changed. May
// be called again for the same node.
template <typename Flow>
template <int kAxis>
void SearchForest<Flow>::Reconsider(const AxisNode<kAxis>& node) {
  int32_t& word = state_.Word(node);
  const int64_t imbalance = state_.Imbalance(node);
  if (IsSourceNode(word) && imbalance <= 0) {
    word = kFreeNode;
    --num_sources_;
  }
  if (imbalance < 0) {
    // An entry of the lists at another label is stale now.
    if (Label(word) != 1 || Parent(word) != kRoot) {
      word = MakeWord(1, kRoot);
    }
    Activate(Untyped(node));
    return;
  }
  if (Label(word) <= 0) {
    if (imbalance > 0 && !IsSourceNode(word)) {
      word = kSourceNode;
      ++num_sources_;
    }
    return;
  }
  Activate(Untyped(node));
  const int32_t parent = Parent(word);
  if (parent == kRoot) {
    QueueDrain(Untyped(node));  // its deficit is gone
    return;
  }
  if (parent < kRoot) {
    const bool holds = [&] {
      if (((state_.ResidualOut(node) >> parent) & 1) == 0) {
        return false;
      }
      const FaceNode above = state_.Across(node, parent);
      return Label(state_.Word(above)) > 0 &&
             Label(state_.Word(above)) < Label(word);
    }();
    if (!holds) {
      MakeOrphan(Untyped(node));
    }
  }
  if (imbalance > 0) {
    QueueDrain(Untyped(node));
  }
}

template class SearchForest<int32_t>;
template class SearchForest<int16_t>;

}  // namespace octacut
