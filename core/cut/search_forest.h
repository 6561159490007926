// Maximum flow by a search forest that grows from the nodes with a deficit
// (the sink side) towards those with an excess (the source side), in the
// family of Boykov & Kolmogorov [PAMI 2004] and of the incremental
// breadth-first search of Goldberg et al. [ESA 2011, ESA 2015].
//
// A node of the forest has a label >= 1 that is greater than its parent's, and
// a residual arc to it. Roots have a deficit. A pass scans the active nodes
// that have the least label: free nodes with a residual arc to them join with
// the next label, and source nodes give what their excess and the arc allow.
// That excess is left inside the forest and drained to the roots level by
// level after the pass, so that paths that join are walked once. Nodes that
// lose their parent are adopted level by level. An excess that the forest
// cannot take makes its node a source node again.
//
// The source side does not grow while searching: its nodes are those with an
// excess, nothing else. Growing it as well was measured
// (docs/experiments/cut_engine.md).
//
// Invariants between passes, with the depth the greatest label:
//  - a residual arc into a node of the forest that is not active comes from a
//    node of the forest;
//  - every node whose label is the depth is active, so that a node that
//    leaves the forest for want of a lower parent may be joined again;
//  - no node of the forest has an excess, a source node always has one, and
//    what is in neither is balanced.
// The search ends when there is no source node or no active one. Then no
// residual arc enters the forest, which holds every deficit; what a residual
// path leads to from the source nodes is the least source side of all minimum
// cuts (source_side.h).
//
// A search covers a range of bricks. Two neighbouring ranges that have been
// searched are joined by Absorb, which keeps their trees [in the spirit of Liu
// & Sun CVPR 2010] and activates the nodes that arcs which open lead to.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/context.h"
#include "core/cut/bucket_queue.h"
#include "core/cut/flow_state.h"

namespace octacut {

// Flow: see FlowState.
template <typename Flow>
class SearchForest {
 public:
  // Plants the roots of bricks [begin, end).
  SearchForest(FlowState<Flow>& state,
               uint32_t begin,
               uint32_t end,
               const Context& context);
  // Takes up a search of all bricks that had ended, from the words it left:
  // `changed` are the voxels around whose faces they may be wrong (see
  // FlowState::GrowTo).
  SearchForest(FlowState<Flow>& state,
               std::span<const NodeId> changed,
               const Context& context);

  // Searches until no flow can be sent inside the range.
  void Run();
  // The same, for a search that was taken up.
  void RunByNeighborhood();
  // Joins the range that follows and opens the arcs between the two.
  void Absorb(SearchForest& next);

 private:
  // A word: label << 7 | flags | parent. The label is > 0 in the forest, -1
  // of a source node and 0 of a free one; the parent is the code of the arc to
  // it.
  static constexpr int32_t kParentMask = 15;
  static constexpr int32_t kRoot = 8;
  static constexpr int32_t kOrphan = 9;
  static constexpr int32_t kExcess = 16;    // an orphan with an excess
  static constexpr int32_t kDraining = 32;  // is in draining_
  static constexpr int32_t kActive = 64;    // is to be scanned
  static constexpr int32_t kFlagMask = 127;
  static constexpr int kLabelShift = 7;
  static constexpr int32_t kMaxLabel = (1 << 24) - 1;
  static_assert(kSourceNode == (-(1 << kLabelShift) | kRoot));
  static_assert(kReachedNode == (kSourceNode | kActive));

  static int32_t Label(int32_t word) { return word >> kLabelShift; }
  static int32_t MakeWord(int32_t label, int32_t low_bits) {
    return label << kLabelShift | low_bits;
  }
  static int32_t Parent(int32_t word) { return word & kParentMask; }
  static int32_t WithParent(int32_t word, int32_t parent) {
    return (word & ~kParentMask) | parent;
  }
  // Words of the forest in the order of their labels: those of label l lie in
  // [RankOf(l), RankOf(l + 1)), and those of other nodes from kNoRank on.
  static constexpr uint32_t kNoRank = 1u << 31;
  static constexpr int32_t kRankOffset = 1 << kLabelShift;
  static uint32_t Rank(int32_t word) {
    return uint32_t(word) - uint32_t(kRankOffset);
  }
  static uint32_t RankOf(int32_t label) {
    return uint32_t(label - 1) << kLabelShift;
  }
  static int32_t LabelOfRank(uint32_t rank) {
    return int32_t(rank >> kLabelShift) + 1;
  }
  // The words around a node whose rank is lower.
  static uint32_t LowerThan(const WordsAround& words, uint32_t rank) {
    return words.Below(kRankOffset, rank);
  }

  template <int kAxis>
  static uint32_t VoxelOf(const AxisNode<kAxis>& node, int code) {
    return code >= 4 ? node.low.index : node.slot.index;
  }
  template <int kAxis>
  static FaceNode Untyped(const AxisNode<kAxis>& node) {
    return {node.slot, uint32_t(kAxis)};
  }

  // growth.cc
  void PlantRoots();
  void Grow();
  template <int kAxis>
  void ScanNode(const AxisNode<kAxis>& node, int32_t label);
  // Sends what a source node has and the arc takes along `code` of a node of
  // the forest. Returns whether the source node is exhausted and free.
  template <int kAxis>
  bool TakeExcess(const FaceNode& source,
                  const AxisNode<kAxis>& node,
                  int code);
  void Activate(const FaceNode& node);

  // draining.cc
  void QueueDrain(const FaceNode& node) {
    int32_t& word = state_.Word(node);
    if ((word & kDraining) == 0) {
      word |= kDraining;
      state_.PrefetchFlowsOf(node.slot.index);
      draining_.Add(Label(word), node.axis, IdOf(node.slot), pool_);
    }
  }
  void Drain();
  template <int kAxis>
  void DrainNode(const AxisNode<kAxis>& node);
  template <int kAxis>
  void SendExcess(const AxisNode<kAxis>& node, int64_t excess);

  // adoption.cc
  void MakeOrphan(const FaceNode& node);
  void Adopt();
  template <int kAxis>
  void AdoptNode(const AxisNode<kAxis>& node, int32_t label);
  template <int kAxis>
  void Lift(const AxisNode<kAxis>& node,
            const WordsAround& words,
            uint32_t arcs,
            uint32_t to_parents);
  // Adopts and drains until neither orphan nor excess is left.
  void Settle();

  // resumption.cc
  void RecoverForest();
  template <int kAxis>
  void Reconsider(const AxisNode<kAxis>& node);

  FlowState<Flow>& state_;
  const Context& context_;
  uint32_t begin_, end_;  // bricks
  ChunkPool pool_;
  int32_t depth_ = 1;
  size_t num_sources_ = 0;
  BucketQueue active_;    // nodes to be scanned; may hold stale entries
  BucketQueue draining_;  // nodes that may have an excess
  BucketQueue orphans_;
};

}  // namespace octacut
