// The state of a maximum flow on the voxel grid itself: no graph is built.
//
// Per voxel 68 bytes: its weight and the signed flow of its twelve edges
// (52, or 26 where flows are narrow; read when flow is pushed), and what
// searching reads (16): a word for each of the nodes on its three low faces,
// and a mask of residual arcs.
//
// Tied faces are no nodes. Their arcs are saturated at the start, so that the
// flow is a pseudoflow: a node has an excess (> 0: it came from the source) or
// a deficit (< 0: the sink waits for it), always recomputed from the flows of
// its eight arcs and its evidence, never stored.
//
// The crust is cut into regions, ranges of bricks. An arc shows in the mask of
// residual arcs only when its voxel and the voxels of both its nodes lie in
// one region, so a search never leaves its region; OpenArcs shows more arcs
// when regions are merged. A high face is blocked while its node is foreign.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/cut/face_node.h"
#include "core/cut/fixed_point.h"
#include "core/cut/flow_records.h"
#include "core/cut/growable_array.h"
#include "core/cut/octahedral_cut.h"
#include "core/cut/octahedron.h"
#include "core/cut/words_around.h"
#include "core/grid/voxel_walk.h"

namespace octacut {

// Weights and flows are of type `Flow`, int32_t or int16_t.
template <typename Flow>
class FlowState {
 public:
  // All tied arcs saturated and what straight lines take is pushed, every
  // node's word kFreeNode. Region r holds the bricks from region_ends[r - 1],
  // or 0, to region_ends[r].
  FlowState(const OctahedralCutProblem& problem,
            const VoxelWalk& walk,
            std::span<const FaceTies> merged_ties,
            std::span<const uint32_t> region_ends,
            const CutScale& scale,
            const Context& context);

  // Whether GrowTo may be asked: the same scale, and evidence if there was any.
  bool GoesOnWith(const OctahedralCutProblem& problem,
                  const CutScale& scale) const {
    return scale_.shift == scale.shift &&
           evidence_.empty() == problem.evidence.empty();
  }
  // Goes over from the grid of the bricks `before` to that of a problem that
  // holds all of its voxels. Those keep their flows as far as weights and ties
  // allow, and their words; new ones are empty; all is one region. Returns the
  // voxels beside whose faces a word may mean something else now. Throws
  // InputError when a voxel is missing.
  std::vector<NodeId> GrowTo(const OctahedralCutProblem& problem,
                             const VoxelWalk& walk,
                             std::span<const FaceTies> merged_ties,
                             std::span<const VoxelGrid::Brick> before,
                             const Context& context);

  static constexpr size_t kBytesPerVoxel =
      sizeof(SearchRecord) + sizeof(FlowRecord<Flow>);

  const VoxelWalk& Walk() const { return *walk_; }
  size_t NumNodes() const { return num_nodes_; }

  template <int kAxis>
  AxisNode<kAxis> Node(NodeId id) const {
    return NodeAt<kAxis>(walk_->At(id >> 6, id & 63));
  }
  template <int kAxis>
  AxisNode<kAxis> NodeAt(const VoxelSlot& slot) const {
    return {slot, walk_->Step(slot, 2 * kAxis)};
  }
  // The voxel on the low side of a node.
  VoxelSlot Low(const FaceNode& node) const {
    return walk_->Step(node.slot, int(2 * node.axis));
  }
  // The node at the other end of an arc.
  template <int kAxis>
  FaceNode Across(const AxisNode<kAxis>& node, int code) const {
    const NodeArc& arc = kNodeArcs[kAxis][code];
    return {walk_->Step(arc.side ? node.low : node.slot, arc.step), arc.axis};
  }
  // Words at the other ends of `arcs`, bit c for code c, all of them inside
  // the region; the others mean nothing.
  template <int kAxis>
  WordsAround Around(const AxisNode<kAxis>& node, uint32_t arcs) const;

  int32_t& Word(const FaceNode& node) {
    return search_[node.slot.index].word[node.axis];
  }
  template <int kAxis>
  int32_t& Word(const AxisNode<kAxis>& node) {
    return search_[node.slot.index].word[kAxis];
  }
  // Another region may change arcs of its own in a mask that both look at.
  uint32_t Residual(uint32_t voxel) const {
    return std::atomic_ref(search_[voxel].residual)
        .load(std::memory_order_relaxed);
  }
  std::span<const SearchRecord> SearchRecords() const {
    return {search_.Data(), search_.Size()};
  }

  // Bit c: the arc of code c leaves / enters the node with a residual.
  struct ResidualArcs {
    uint32_t out, in;
  };
  template <int kAxis>
  ResidualArcs ResidualOf(const AxisNode<kAxis>& node) const {
    const uint32_t own = Residual(node.slot.index);
    const uint32_t low = Residual(node.low.index);
    return {ArcsOut(own, 2 * kAxis) | ArcsOut(low, 2 * kAxis + 1) << 4,
            ArcsIn(own, 2 * kAxis) | ArcsIn(low, 2 * kAxis + 1) << 4};
  }
  template <int kAxis>
  uint32_t ResidualOut(const AxisNode<kAxis>& node) const {
    return ResidualOf(node).out;
  }
  template <int kAxis>
  uint32_t ResidualIn(const AxisNode<kAxis>& node) const {
    return ResidualOf(node).in;
  }

  int32_t Capacity(uint32_t voxel, uint32_t arc) const {
    return flows_[voxel].Capacity(arc);
  }
  // Sends `amount` along an arc; returns whether that saturates it.
  bool Push(uint32_t voxel, uint32_t arc, int32_t amount) {
    const bool saturated = flows_[voxel].Push(arc, amount);
    const uint32_t residual = Residual(voxel);
    SetResidual(voxel,
                (residual | 1u << kOctahedron.reverse[arc]) &
                    ~(uint32_t{saturated} << arc));
    return saturated;
  }

  // Shows the arcs of a voxel whose high faces have their nodes in bricks
  // below `end`; returns those that have a residual and did not show before,
  // bit a for arc a.
  uint32_t OpenArcs(const VoxelSlot& slot, uint32_t end);
  // The node of a voxel's face, which must exist.
  FaceNode NodeOf(const VoxelSlot& slot, int face) const {
    return {walk_->Step(slot, (face & 1) ? face : kNumFaces),
            uint32_t(face / 2)};
  }

  // Excess (> 0) or deficit (< 0) of a node.
  template <int kAxis>
  int64_t Imbalance(const AxisNode<kAxis>& node) const;
  int64_t Imbalance(const FaceNode& node) const {
    switch (node.axis) {
      case 0:
        return Imbalance(NodeAt<0>(node.slot));
      case 1:
        return Imbalance(NodeAt<1>(node.slot));
      default:
        return Imbalance(NodeAt<2>(node.slot));
    }
  }

  // Whether a node has no imbalance before the search: it is beside neither a
  // tied face nor evidence. May say no where it is so.
  bool StartsBalanced(const FaceNode& node) const {
    return evidence_.empty() &&
           ((Residual(node.slot.index) | Residual(Low(node).index)) >>
            kNumOctahedronArcs) == 0;
  }

  template <int kAxis>
  void PrefetchSearch(NodeId id) const {
    const AxisNode node = Node<kAxis>(id);
    __builtin_prefetch(&search_[node.slot.index], 1);
    __builtin_prefetch(&search_[node.low.index], 1);
  }
  template <int kAxis>
  void PrefetchFlows(NodeId id) const {
    const AxisNode node = Node<kAxis>(id);
    for (const uint32_t voxel : {node.slot.index, node.low.index}) {
      __builtin_prefetch(&search_[voxel], 1);
      __builtin_prefetch(&flows_[voxel], 1);
      __builtin_prefetch(&flows_[voxel].flow[11], 1);
    }
  }

  // The record of a voxel alone, for a list too short to look ahead in.
  void PrefetchFlowsOf(uint32_t voxel) const {
    __builtin_prefetch(&flows_[voxel], 1);
    __builtin_prefetch(&flows_[voxel].flow[11], 1);
  }

  // The flow value when it is a maximum: the capacity into the sink less the
  // deficits that are left.
  int64_t FlowValue(const Context& context) const;
  // Frees the flows; only SearchRecords may be asked afterwards.
  void ReleaseFlows() { flows_.Release(); }

 private:
  void InitVoxel(const OctahedralCutProblem& problem,
                 const VoxelSlot& slot,
                 FaceTies ties,
                 uint32_t region_end);
  // straight_paths.cc
  struct Line;
  void PushAlongLines(std::span<const FaceTies> merged_ties,
                      const Context& context);
  template <int kFrom>
  void PushAlongLine(std::span<const FaceTies> merged_ties,
                     const VoxelSlot& first);
  template <int kFrom>
  int64_t MeasureWays(FaceTies ties, Line& line, uint32_t k) const;
  template <int kFrom>
  void PushThrough(const Line& line, uint32_t k, int64_t amount);
  // Nodes of a voxel and what it adds to the capacity into the sink.
  struct Tally {
    size_t num_nodes = 0;
    int64_t capacity = 0;
    void Add(const Tally& other) {
      num_nodes += other.num_nodes;
      capacity += other.capacity;
    }
  };
  Tally TallyVoxel(const OctahedralCutProblem& problem,
                   const VoxelSlot& slot,
                   FaceTies ties) const;
  void TakeTallies(std::span<const Tally> tallies);
  // Moves every voxel's records to its slot in the problem's grid.
  void Spread(const VoxelGrid& grid, std::span<const VoxelGrid::Brick> before);
  // Brings a voxel's records in line with the problem; returns whether that
  // changed any.
  bool Revise(const OctahedralCutProblem& problem,
              const VoxelSlot& slot,
              FaceTies ties);
  void SetResidual(uint32_t voxel, uint32_t residual) {
    std::atomic_ref(search_[voxel].residual)
        .store(residual, std::memory_order_relaxed);
  }

  const VoxelWalk* walk_;
  CutScale scale_;
  size_t num_nodes_ = 0;
  int64_t sink_capacity_ = 0;
  GrowableArray<SearchRecord> search_;
  GrowableArray<FlowRecord<Flow>> flows_;
  std::vector<int32_t> evidence_;  // a voxel's share in each of its faces
};

template <typename Flow>
template <int kAxis>
inline int64_t FlowState<Flow>::Imbalance(const AxisNode<kAxis>& node) const {
  int64_t inflow = -flows_[node.slot.index].template Outflow<2 * kAxis>() -
                   flows_[node.low.index].template Outflow<2 * kAxis + 1>();
  if (!evidence_.empty()) {
    inflow -= int64_t{evidence_[node.slot.index]} + evidence_[node.low.index];
  }
  return inflow;
}

template <typename Flow>
template <int kAxis>
inline WordsAround FlowState<Flow>::Around(const AxisNode<kAxis>& node,
                                           uint32_t arcs) const {
  constexpr int kNext = 2 * ((kAxis + 1) % 3) + 1;
  constexpr int kLast = 2 * ((kAxis + 2) % 3) + 1;
  // Elsewhere there may be no voxel, or one that another thread works on.
  const auto reach = [&](uint32_t codes, const VoxelSlot& from, int face) {
    const uint32_t index = walk_->Step(from, face).index;
    return (arcs & codes) ? index : node.slot.index;
  };
  const uint32_t holders[6] = {node.slot.index,
                               (arcs & 0x50) ? node.low.index : node.slot.index,
                               reach(0x02, node.slot, kNext),
                               reach(0x08, node.slot, kLast),
                               reach(0x20, node.low, kNext),
                               reach(0x80, node.low, kLast)};
  const auto word = [&](int code) {
    return search_[holders[kNodeArcHolder[code]]]
        .word[kNodeArcs[kAxis][code].axis];
  };
  return WordsAround(
      {word(0), word(1), word(2), word(3), word(4), word(5), word(6), word(7)});
}

}  // namespace octacut
