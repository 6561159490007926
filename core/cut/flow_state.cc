#include "core/cut/flow_state.h"

#include <algorithm>
#include <bit>

#include "core/base/parallel.h"
#include "core/cut/cut_problem.h"

namespace octacut {
namespace {

// Edges into the sink: those of a face tied inside and one that is not.
int NumSinkEdges(FaceTies ties) {
  return NumCutEdges(FaceLabels(ties >> kNumFaces));
}

}  // namespace

template <typename Flow>
FlowState<Flow>::FlowState(const OctahedralCutProblem& problem,
                           const VoxelWalk& walk,
                           std::span<const FaceTies> merged_ties,
                           std::span<const uint32_t> region_ends,
                           const CutScale& scale,
                           const Context& context)
    : walk_(&walk),
      scale_(scale),
      search_(problem.crust->Size()),
      flows_(problem.crust->Size()),
      evidence_(problem.evidence.size()) {
  std::vector<Tally> tallies(region_ends.size());
  ParallelFor(context, region_ends.size(), 1, [&](size_t region, size_t) {
    const size_t begin = region == 0 ? 0 : region_ends[region - 1];
    walk.ForEach(begin, region_ends[region], [&](const VoxelSlot& slot) {
      const uint32_t i = slot.index;
      const FaceTies ties = merged_ties[i];
      InitVoxel(problem, slot, ties, region_ends[region]);
      for (uint32_t axis = 0; axis < 3; ++axis) {
        const bool is_node = ((ties >> (2 * axis)) & 0x41) == 0;
        search_[i].word[axis] = is_node ? kFreeNode : kNoNode;
      }
      tallies[region].Add(TallyVoxel(problem, slot, ties));
    });
  });
  TakeTallies(tallies);
  PushAlongLines(merged_ties, context);
}

template <typename Flow>
auto FlowState<Flow>::TallyVoxel(const OctahedralCutProblem& problem,
                                 const VoxelSlot& slot,
                                 FaceTies ties) const -> Tally {
  Tally tally;
  tally.capacity = int64_t{NumSinkEdges(ties)} * flows_[slot.index].weight;
  for (uint32_t axis = 0; axis < 3; ++axis) {
    if ((ties >> (2 * axis)) & 0x41) {
      continue;
    }
    ++tally.num_nodes;
    if (!evidence_.empty()) {
      const float low = problem.evidence[Low({slot, axis}).index];
      const float high = problem.evidence[slot.index];
      tally.capacity += std::max<int64_t>(
          0, int64_t{scale_.FaceEvidence(low)} + scale_.FaceEvidence(high));
    }
  }
  return tally;
}

template <typename Flow>
void FlowState<Flow>::TakeTallies(std::span<const Tally> tallies) {
  Tally sum;
  for (const Tally& tally : tallies) {
    sum.Add(tally);
  }
  num_nodes_ = sum.num_nodes;
  sink_capacity_ = sum.capacity;
}

template <typename Flow>
void FlowState<Flow>::InitVoxel(const OctahedralCutProblem& problem,
                                const VoxelSlot& slot,
                                FaceTies ties,
                                uint32_t region_end) {
  const uint32_t voxel = slot.index;
  const int32_t weight = scale_.Weight(problem.weights[voxel]);
  FlowRecord<Flow>& record = flows_[voxel];
  record = {Flow(weight), {}};
  if (!problem.evidence.empty()) {
    evidence_[voxel] = scale_.FaceEvidence(problem.evidence[voxel]);
  }
  const int outside = ties & kAllFaces;
  const int inside = ties >> kNumFaces;
  const uint32_t tied = uint32_t(outside | inside);
  uint32_t blocked = tied;
  for (int face = 1; face < kNumFaces; face += 2) {
    // A brick beside a high face comes later in Morton order.
    const bool foreign = walk_->StepBrick(slot, face) >= region_end;
    blocked |= uint32_t{foreign} << face;
  }
  search_[voxel].residual = kFreeArcs[blocked] | blocked << kNumOctahedronArcs;
  if (tied != 0) {
    record.SaturateTies(outside, inside);
  }
}

template <typename Flow>
uint32_t FlowState<Flow>::OpenArcs(const VoxelSlot& slot, uint32_t end) {
  const uint32_t residual = Residual(slot.index);
  const uint32_t before = residual >> kNumOctahedronArcs;
  uint32_t blocked = before;
  for (int face = 1; face < kNumFaces; face += 2) {
    if ((blocked >> face) & 1) {
      const uint32_t owner = walk_->Neighbor(slot, face);
      if (owner != VoxelGrid::kNone && owner < walk_->FirstVoxelOrEnd(end) &&
          search_[owner].word[face / 2] != kNoNode) {
        blocked &= ~(1u << face);
      }
    }
  }
  if (blocked == before) {
    return 0;
  }
  uint32_t opened = kFreeArcs[blocked] & ~kFreeArcs[before];
  for (uint32_t rest = opened; rest != 0; rest &= rest - 1) {
    const uint32_t arc = uint32_t(std::countr_zero(rest));
    if (Capacity(slot.index, arc) == 0) {
      opened &= ~(1u << arc);
    }
  }
  constexpr uint32_t kArcs = (1u << kNumOctahedronArcs) - 1;
  SetResidual(slot.index,
              (residual & kArcs) | blocked << kNumOctahedronArcs | opened);
  return opened;
}

template <typename Flow>
int64_t FlowState<Flow>::FlowValue(const Context& context) const {
  const int64_t deficits = ParallelSum(
      context,
      walk_->NumBricks(),
      kCutBrickGrain,
      [&](size_t begin, size_t end) {
        int64_t sum = 0;
        walk_->ForEach(begin, end, [&](const VoxelSlot& slot) {
          for (uint32_t axis = 0; axis < 3; ++axis) {
            // Free nodes and those that are none have none.
            if (search_[slot.index].word[axis] > kNoNode) {
              sum += std::min<int64_t>(0, Imbalance(FaceNode{slot, axis}));
            }
          }
        });
        return sum;
      });
  return sink_capacity_ + deficits;
}

template class FlowState<int32_t>;
template class FlowState<int16_t>;

}  // namespace octacut
