// Planting the roots and growing the forests, one label a pass.
#include <bit>

#include "core/base/error.h"
#include "core/cut/search_forest.h"

namespace octacut {

SearchForest::SearchForest(FlowState& state, const Context& context)
    : state_(state), context_(context) {}

void SearchForest::Run() {
  PlantRoots();
  while (!Frontier(Forest::kSource).Empty()) {
    context_.ThrowIfCancelled();
    // The smaller frontier first; once the sink forest is complete, the
    // source forest takes the free nodes that are left.
    const size_t source = Frontier(Forest::kSource).Size();
    const size_t sink = Frontier(Forest::kSink).Size();
    if (sink == 0 || source <= sink) {
      Grow<Forest::kSource>();
    } else {
      Grow<Forest::kSink>();
    }
  }
}

void SearchForest::PlantRoots() {
  state_.Walk().ForEach(0, state_.Walk().NumBricks(), [&](VoxelPlace place) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const FaceNode node{place, axis};
      int32_t& word = state_.Word(node);
      if (word == FlowState::kNoNode) {
        continue;
      }
      const int64_t imbalance = state_.Imbalance(node, state_.Low(node));
      if (imbalance > 0) {
        word = MakeWord<Forest::kSource>(1, kRoot);
        Frontier(Forest::kSource).Add(IdOf(node), pool_);
      } else if (imbalance < 0) {
        word = MakeWord<Forest::kSink>(1, kRoot);
        Frontier(Forest::kSink).Add(IdOf(node), pool_);
      }
    }
  });
}

template <Forest F>
void SearchForest::Grow() {
  const int32_t label = Depth(F)++;
  if (label >= kMaxLabel) {
    throw InvariantError("cut: the search is deeper than any path can be");
  }
  growing_ = F;
  scanning_label_ = label;
  std::swap(again_, Frontier(F));
  while (!again_.Empty()) {
    ChunkList now = std::exchange(again_, {});
    now.Consume(
        pool_,
        [&](NodeId id) { state_.PrefetchSearch(id); },
        [&](NodeId id) {
          if (!ScanNode<F>(id, label)) {
            again_.Add(id, pool_);
          }
        });
    Settle();
  }
  scanning_label_ = 0;
}

// Returns false when the node may touch the other forest still.
template <Forest F>
bool SearchForest::ScanNode(NodeId id, int32_t label) {
  const FaceNode node = state_.Node(id);
  const int32_t word = state_.Word(node);
  if (Label<F>(word) != label || Parent(word) == kOrphan) {
    return true;  // moved since, or to be listed again when it is adopted
  }
  const VoxelPlace low = state_.Low(node);
  bool done = true;
  for (uint32_t arcs = ArcsAway<F>(node, low); arcs != 0; arcs &= arcs - 1) {
    const NodeArc& arc = ArcOf(node, std::countr_zero(arcs));
    const FaceNode other = Follow(node, low, arc);
    int32_t& other_word = state_.Word(other);
    const int32_t other_label = Label<F>(other_word);
    if (other_label > 0) {
      continue;
    }
    if (other_label == 0) {
      other_word = MakeWord<F>(label + 1, arc.back);
      Frontier(F).Add(IdOf(other), pool_);
      continue;
    }
    const uint32_t voxel = VoxelOf(node, low, arc);
    done &= F == Forest::kSource ? Augment(node, other, voxel, arc.out)
                                 : Augment(other, node, voxel, arc.in);
  }
  return done;
}

template <Forest F>
void SearchForest::Enlist(NodeId id, int32_t label) {
  if (label == Depth(F)) {
    Frontier(F).Add(id, pool_);
  } else if (F == growing_ && label == scanning_label_) {
    again_.Add(id, pool_);
  }
}

template void SearchForest::Enlist<Forest::kSource>(NodeId, int32_t);
template void SearchForest::Enlist<Forest::kSink>(NodeId, int32_t);

}  // namespace octacut
