// Planting the roots, growing the forests, and joining two ranges.
#include <bit>

#include "core/base/error.h"
#include "core/cut/search_forest.h"

namespace octacut {

SearchForest::SearchForest(FlowState& state,
                           uint32_t begin,
                           uint32_t end,
                           double source_share,
                           const Context& context)
    : state_(state),
      context_(context),
      begin_(begin),
      end_(end),
      source_share_(source_share) {
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
        word = MakeWord<Forest::kSource>(1, kRoot);
        Activate<Forest::kSource>(node);
      } else if (imbalance < 0) {
        word = MakeWord<Forest::kSink>(1, kRoot);
        Activate<Forest::kSink>(node);
      }
    }
  });
}

void SearchForest::Run() {
  while (!Active(Forest::kSource).Empty() && !Active(Forest::kSink).Empty()) {
    context_.ThrowIfCancelled();
    if (double(Active(Forest::kSource).Size()) <=
        source_share_ * double(Active(Forest::kSink).Size())) {
      Grow<Forest::kSource>();
    } else {
      Grow<Forest::kSink>();
    }
  }
}

void SearchForest::Finish() {
  while (!Active(Forest::kSource).Empty()) {
    context_.ThrowIfCancelled();
    Grow<Forest::kSource>();
  }
}

template <Forest F>
void SearchForest::Grow() {
  const int32_t label = Active(F).Lowest();
  if (label >= kMaxLabel) {
    throw InvariantError("cut: the search is deeper than any path can be");
  }
  Depth(F) = std::max(Depth(F), label + 1);
  Active(F).Consume(
      label,
      pool_,
      [&](auto axis, NodeId id) { state_.PrefetchSearch<axis()>(id); },
      [&](auto axis, NodeId id) {
        const AxisNode node = state_.Node<axis()>(id);
        int32_t& word = state_.Word(node);
        if ((word & kActive) == 0 || Label<F>(word) < label) {
          return;  // a stale entry
        }
        word &= ~kActive;
        if (Label<F>(word) > label || Parent(word) == kOrphan ||
            !ScanNode<F>(node, label)) {
          Activate<F>(Untyped(node));
        }
      });
  Settle();
}

// Returns false when the node may touch the other forest still.
template <Forest F, int kAxis>
bool SearchForest::ScanNode(const AxisNode<kAxis>& node, int32_t label) {
  uint32_t arcs = ArcsAway<F>(node);
  const WordsAround words = state_.Around(node, arcs);
  uint32_t joined = 0;
  for (int code = kNumNodeArcs - 1; code >= 0; --code) {
    joined += joined + (Rank<F>(words[code]) < kNoRank);
  }
  bool done = true;
  for (arcs &= ~joined; arcs != 0; arcs &= arcs - 1) {
    const int code = std::countr_zero(arcs);
    const NodeArc& arc = kNodeArcs[kAxis][code];
    const FaceNode other = state_.Across(node, code);
    if (Label<F>(words[code]) == 0) {
      state_.Word(other) = MakeWord<F>(label + 1, arc.back);
      Activate<F>(other);
      continue;
    }
    const uint32_t voxel = VoxelOf(node, code);
    done &= F == Forest::kSource ? Augment(Untyped(node), other, voxel, arc.out)
                                 : Augment(other, Untyped(node), voxel, arc.in);
  }
  return done;
}

template <Forest F>
void SearchForest::Activate(const FaceNode& node) {
  int32_t& word = state_.Word(node);
  if ((word & kActive) == 0) {
    word |= kActive;
    Active(F).Add(Label<F>(word), node.axis, IdOf(node.place), pool_);
  }
}
template void SearchForest::Activate<Forest::kSource>(const FaceNode&);
template void SearchForest::Activate<Forest::kSink>(const FaceNode&);

void SearchForest::Absorb(SearchForest& next) {
  const uint32_t middle = end_;
  end_ = next.end_;
  for (int forest = 0; forest < 2; ++forest) {
    depth_[forest] = std::max(depth_[forest], next.depth_[forest]);
    active_[forest].Append(std::move(next.active_[forest]));
  }
  pool_.Absorb(next.pool_);
  // Only bricks of the lower range look across: high faces lead upwards.
  for (uint32_t brick = begin_; brick < middle; ++brick) {
    const auto crosses = [&](int face) {
      const uint32_t beside = state_.Walk().BrickBeside(brick, face);
      return beside >= middle && beside < end_;
    };
    if (crosses(1) || crosses(3) || crosses(5)) {
      state_.Walk().ForEach(brick, brick + 1, [&](const VoxelPlace& place) {
        state_.OpenArcs(
            place, end_, [&](uint32_t arc) { WakeEnds(place, arc); });
      });
    }
  }
}

// Activates the ends of a residual arc that the invariant asks for.
void SearchForest::WakeEnds(const VoxelPlace& place, uint32_t arc) {
  const FaceNode from = state_.NodeOf(place, int(arc / 4));
  const FaceNode to = state_.NodeOf(place, kOctahedron.head[arc]);
  const int32_t from_label = Label<Forest::kSource>(state_.Word(from));
  const int32_t to_label = Label<Forest::kSource>(state_.Word(to));
  if (from_label > 0 && to_label <= 0) {
    Activate<Forest::kSource>(from);
  }
  if (to_label < 0 && from_label >= 0) {
    Activate<Forest::kSink>(to);
  }
}

}  // namespace octacut
