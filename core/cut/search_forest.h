// Maximum flow by two search forests that grow towards each other, one from
// the nodes with an excess (source), one from those with a deficit (sink), in
// the family of Boykov & Kolmogorov [PAMI 2004] and of the incremental
// breadth-first search of Goldberg et al. [ESA 2011, ESA 2015].
//
// A node of a forest has a label >= 1 that is greater than its parent's, and
// a residual arc from its parent (source) or to it (sink). Roots hold an
// imbalance. One pass scans the active nodes of a forest that have the least
// label, joining free nodes with the next label. Where the forests touch, flow
// is sent: exactly as much as the source forest can supply along the path to
// its root; in the sink forest it is left at the node that receives it, and
// drained to the roots level by level after the pass, so that paths that join
// are walked once. Nodes that lose their parent are adopted level by level.
// What cannot be drained makes its node a root of the source forest.
//
// Invariants between passes, with a forest's depth its greatest label:
//  - a residual arc from a source node that is not active leads to a source
//    node; one into a sink node that is not active comes from a sink node;
//  - every node whose label is the depth is active, so that a node that
//    leaves a forest for want of a lower parent may be joined again;
//  - no node of the sink forest has an excess, and of the source forest only
//    roots have an imbalance, an excess.
// The search ends when no source node is active: then no residual arc leaves
// the source forest, which holds every excess and nothing that an excess does
// not reach: the least source side of all minimum cuts.
//
// A search covers a range of bricks. Two neighbouring ranges that have been
// searched are joined by Absorb, which keeps their trees [in the spirit of Liu
// & Sun CVPR 2010] and activates the nodes at arcs that open.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/context.h"
#include "core/cut/bucket_queue.h"
#include "core/cut/flow_state.h"

namespace octacut {

enum class Forest { kSource = 0, kSink = 1 };
inline constexpr Forest Other(Forest forest) {
  return forest == Forest::kSource ? Forest::kSink : Forest::kSource;
}

class SearchForest {
 public:
  // Plants the roots of bricks [begin, end). `source_share`: see SearchPlan.
  SearchForest(FlowState& state,
               uint32_t begin,
               uint32_t end,
               double source_share,
               const Context& context);

  // Searches until no flow can be sent inside the range.
  void Run();
  // Gives the source forest every free node that it reaches; after Run.
  void Finish();
  // Joins the range that follows and opens the arcs between the two.
  void Absorb(SearchForest& next);

  // Whether a node's word says that it is on the source side.
  static bool IsSource(int32_t word) { return (word >> kLabelShift) > 0; }

  size_t QueueBytes() const { return pool_.MemoryBytes(); }

 private:
  // A word: label << 7 | flags | parent. The label is > 0 in the source
  // forest, < 0 in the sink forest and 0 for a free node; the parent is the
  // code of the arc to it.
  static constexpr int32_t kParentMask = 15;
  static constexpr int32_t kRoot = 8;
  static constexpr int32_t kOrphan = 9;
  static constexpr int32_t kExcess = 16;    // an orphan with an excess
  static constexpr int32_t kDraining = 32;  // is in draining_
  static constexpr int32_t kActive = 64;    // is to be scanned
  static constexpr int32_t kFlagMask = 127;
  static constexpr int kLabelShift = 7;
  static constexpr int32_t kMaxLabel = 1 << 24;

  // Label of a word in forest F; negative in the other one.
  template <Forest F>
  static int32_t Label(int32_t word) {
    const int32_t label = word >> kLabelShift;
    return F == Forest::kSource ? label : -label;
  }
  template <Forest F>
  static int32_t MakeWord(int32_t label, int32_t low_bits) {
    return (F == Forest::kSource ? label : -label) * (kFlagMask + 1) + low_bits;
  }
  static int32_t Parent(int32_t word) { return word & kParentMask; }
  static int32_t WithParent(int32_t word, int32_t parent) {
    return (word & ~kParentMask) | parent;
  }
  // Words of forest F in the order of their labels: those of label l lie in
  // [RankOf(l), RankOf(l + 1)), and those of other nodes from kNoRank on.
  static constexpr uint32_t kNoRank = 1u << 31;
  template <Forest F>
  static uint32_t Rank(int32_t word) {
    return F == Forest::kSource ? uint32_t(word) - (kFlagMask + 1)
                                : ~uint32_t(word);
  }
  static uint32_t RankOf(int32_t label) {
    return uint32_t(label - 1) << kLabelShift;
  }
  static int32_t LabelOfRank(uint32_t rank) {
    return int32_t(rank >> kLabelShift) + 1;
  }

  // Whether a node of forest F hangs from the arc with this code; that of a
  // node of no forest is none.
  template <Forest F>
  static bool IsChild(int32_t word, int32_t code) {
    constexpr int32_t kSign = std::numeric_limits<int32_t>::min();
    return (word & (kSign | kParentMask)) ==
           (code | (F == Forest::kSource ? 0 : kSign));
  }

  // Codes of the arcs along which forest F may grow from a node, and those
  // by which the node may hang from a parent.
  template <Forest F, int kAxis>
  uint32_t ArcsAway(const AxisNode<kAxis>& node) const {
    return F == Forest::kSource ? state_.ResidualOut(node)
                                : state_.ResidualIn(node);
  }
  template <Forest F, int kAxis>
  uint32_t ArcsToParents(const AxisNode<kAxis>& node) const {
    return ArcsAway<Other(F)>(node);
  }
  template <int kAxis>
  static uint32_t VoxelOf(const AxisNode<kAxis>& node, int code) {
    return code >= 4 ? node.low.index : node.place.index;
  }
  template <int kAxis>
  static FaceNode Untyped(const AxisNode<kAxis>& node) {
    return {node.place, uint32_t(kAxis)};
  }

  int32_t& Depth(Forest forest) { return depth_[int(forest)]; }
  BucketQueue& Active(Forest forest) { return active_[int(forest)]; }

  // growth.cc
  void PlantRoots();
  template <Forest F>
  void Grow();
  template <Forest F, int kAxis>
  bool ScanNode(const AxisNode<kAxis>& node, int32_t label);
  template <Forest F>
  void Activate(const FaceNode& node);
  void WakeEnds(const VoxelPlace& place, uint32_t arc);

  // augmentation.cc
  // Sends what the source forest can along source_node -> sink_node, `arc` of
  // `voxel`. Returns whether that saturates the arc.
  bool Augment(const FaceNode& source_node,
               const FaceNode& sink_node,
               uint32_t voxel,
               uint32_t arc);
  int64_t TraceSupply(FaceNode node);
  void Drain();
  template <int kAxis>
  void DrainNode(const AxisNode<kAxis>& node);
  template <int kAxis>
  void SendExcess(const AxisNode<kAxis>& node, int64_t excess);
  void QueueDrain(const FaceNode& node);

  // adoption.cc
  template <Forest F>
  void MakeOrphan(const FaceNode& node);
  template <Forest F>
  void Adopt();
  template <Forest F, int kAxis>
  void AdoptNode(const AxisNode<kAxis>& node, int32_t label);
  template <Forest F, int kAxis>
  void Lift(const AxisNode<kAxis>& node,
            const WordsAround& words,
            uint32_t arcs,
            uint32_t to_parents);
  template <Forest F>
  void Leave(const FaceNode& node);
  // Adopts and drains until neither orphan nor excess is left.
  void Settle();

  FlowState& state_;
  const Context& context_;
  uint32_t begin_, end_;  // bricks
  double source_share_;
  ChunkPool pool_;
  int32_t depth_[2] = {1, 1};
  BucketQueue active_[2];  // nodes to be scanned; may hold stale entries
  bool unsettled_ = false;
  BucketQueue draining_;  // sink nodes that may have an excess
  BucketQueue orphans_[2];

  struct PathStep {
    FaceNode child;
    uint32_t voxel;
    uint32_t arc;
  };
  std::vector<PathStep> path_;  // from a source node up to its root
  FaceNode path_root_ = {};
};

}  // namespace octacut
