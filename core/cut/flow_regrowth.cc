// Taking the state of a flow over to a crust that has grown.
#include <algorithm>
#include <bit>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cut/cut_problem.h"
#include "core/cut/flow_state.h"

namespace octacut {
namespace {

void CheckHolds(const VoxelGrid& grid,
                std::span<const VoxelGrid::Brick> before) {
  for (const VoxelGrid::Brick& brick : before) {
    const VoxelGrid::Index found = grid.FindBrick(brick.key);
    if (found == VoxelGrid::kNone ||
        (brick.mask & ~grid.Bricks()[found].mask) != 0) {
      throw InputError(
          "cut problem: the crust lacks voxels of the one it has grown from");
    }
  }
}

}  // namespace

template <typename Flow>
std::vector<NodeId> FlowState<Flow>::GrowTo(
    const OctahedralCutProblem& problem,
    const VoxelWalk& walk,
    std::span<const FaceTies> merged_ties,
    std::span<const VoxelGrid::Brick> before,
    const Context& context) {
  CheckHolds(*problem.crust, before);
  Spread(*problem.crust, before);
  walk_ = &walk;
  const size_t num_chunks = NumChunks(walk.NumBricks(), kCutBrickGrain);
  std::vector<Tally> tallies(num_chunks);
  std::vector<std::vector<NodeId>> changed(num_chunks);
  ParallelChunks(context,
                 walk.NumBricks(),
                 kCutBrickGrain,
                 [&](size_t chunk, size_t begin, size_t end) {
                   walk.ForEach(begin, end, [&](const VoxelSlot& slot) {
                     const FaceTies ties = merged_ties[slot.index];
                     if (Revise(problem, slot, ties)) {
                       changed[chunk].push_back(IdOf(slot));
                     }
                     tallies[chunk].Add(TallyVoxel(problem, slot, ties));
                   });
                 });
  TakeTallies(tallies);
  std::vector<NodeId> all;
  for (const std::vector<NodeId>& part : changed) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

// From the last voxel to the first: none moves to a lower index, so no record
// is overwritten before it has moved.
template <typename Flow>
void FlowState<Flow>::Spread(const VoxelGrid& grid,
                             std::span<const VoxelGrid::Brick> before) {
  search_.Resize(grid.Size());
  flows_.Resize(grid.Size());
  evidence_.resize(evidence_.empty() ? 0 : grid.Size());
  const auto last_below = [](uint64_t mask, int bit) {
    return uint32_t(std::popcount(mask & ((uint64_t{1} << bit) - 1)));
  };
  size_t from = before.size();
  for (size_t b = grid.Bricks().size(); b-- > 0;) {
    const VoxelGrid::Brick& brick = grid.Bricks()[b];
    const bool found = from > 0 && before[from - 1].key == brick.key;
    from -= found;
    for (uint64_t rest = brick.mask; rest != 0;) {
      const int bit = std::bit_width(rest) - 1;
      rest &= ~(uint64_t{1} << bit);
      const uint32_t to = brick.first + last_below(brick.mask, bit);
      if (found && ((before[from].mask >> bit) & 1)) {
        const uint32_t old =
            before[from].first + last_below(before[from].mask, bit);
        search_[to] = search_[old];
        flows_[to] = flows_[old];
        if (!evidence_.empty()) {
          evidence_[to] = evidence_[old];
        }
      } else {
        // No weight is 0, so Revise will find it changed.
        search_[to] = {{kNoNode, kNoNode, kNoNode}, 0};
        flows_[to] = {};
      }
    }
  }
}

template <typename Flow>
bool FlowState<Flow>::Revise(const OctahedralCutProblem& problem,
                             const VoxelSlot& slot,
                             FaceTies ties) {
  const uint32_t voxel = slot.index;
  SearchRecord& search = search_[voxel];
  FlowRecord<Flow>& record = flows_[voxel];
  const Flow weight = Flow(scale_.Weight(problem.weights[voxel]));
  const int outside = ties & kAllFaces;
  const int inside = ties >> kNumFaces;
  const uint32_t tied = uint32_t(outside | inside);
  bool changed =
      record.weight != weight || search.residual >> kNumOctahedronArcs != tied;
  if (!evidence_.empty()) {
    const int32_t evidence = scale_.FaceEvidence(problem.evidence[voxel]);
    changed |= std::exchange(evidence_[voxel], evidence) != evidence;
  }
  if (!changed && tied == 0) {
    return false;
  }
  record.weight = weight;
  changed |= record.SaturateTies(outside, inside);
  if (!changed) {
    return false;
  }
  for (Flow& flow : record.flow) {
    flow = std::clamp(flow, Flow(-weight), weight);
  }
  search.residual = kFreeArcs[tied] | tied << kNumOctahedronArcs;
  for (uint32_t arc = 0; arc < kNumOctahedronArcs; ++arc) {
    search.residual &= ~(uint32_t{Capacity(voxel, arc) == 0} << arc);
  }
  for (uint32_t axis = 0; axis < 3; ++axis) {
    int32_t& word = search.word[axis];
    const bool is_node = ((tied >> (2 * axis)) & 1) == 0;
    word = !is_node ? kNoNode : word == kNoNode ? kFreeNode : word;
  }
  return true;
}

template class FlowState<int32_t>;
template class FlowState<int16_t>;

}  // namespace octacut
