#include "core/cut/flow_state.h"

#include <algorithm>
#include <numeric>

#include "core/base/parallel.h"
#include "core/cut/cut_problem.h"

namespace octacut {
namespace {

// Residual arcs at the start by tied faces: those between two faces that are
// not tied.
constexpr std::array<uint32_t, 64> MakeFreeArcs() {
  std::array<uint32_t, 64> free = {};
  for (int tied = 0; tied < 64; ++tied) {
    for (int arc = 0; arc < kNumOctahedronArcs; ++arc) {
      const bool is_free = ((tied >> (arc / 4)) & 1) == 0 &&
                           ((tied >> kOctahedron.head[arc]) & 1) == 0;
      free[tied] |= uint32_t(is_free) << arc;
    }
  }
  return free;
}
constexpr std::array<uint32_t, 64> kFreeArcs = MakeFreeArcs();

// Edges into the sink: those of a face tied inside and one that is not.
int NumSinkEdges(FaceTies ties) {
  return NumCutEdges(FaceLabels(ties >> kNumFaces));
}

}  // namespace

FlowState::FlowState(const OctahedralCutProblem& problem,
                     const VoxelWalk& walk,
                     std::span<const FaceTies> merged_ties,
                     const Context& context)
    : walk_(walk),
      num_voxels_(problem.crust->Size()),
      search_(std::make_unique_for_overwrite<SearchRecord[]>(num_voxels_)),
      flows_(std::make_unique_for_overwrite<FlowRecord[]>(num_voxels_)) {
  const bool with_evidence = !problem.evidence.empty();
  evidence_.resize(problem.evidence.size());
  std::vector<size_t> num_nodes(NumChunks(walk.NumBricks(), kCutBrickGrain));
  std::vector<int64_t> capacity(num_nodes.size());
  ParallelChunks(context,
                 walk.NumBricks(),
                 kCutBrickGrain,
                 [&](size_t chunk, size_t begin, size_t end) {
                   walk.ForEach(begin, end, [&](const VoxelPlace& place) {
                     const uint32_t i = place.index;
                     const FaceTies ties = merged_ties[i];
                     InitVoxel(FixedWeight(problem.weights[i]), ties, i);
                     capacity[chunk] +=
                         int64_t{NumSinkEdges(ties)} * flows_[i].weight;
                     if (with_evidence) {
                       evidence_[i] = FixedFaceEvidence(problem.evidence[i]);
                     }
                     for (uint32_t axis = 0; axis < 3; ++axis) {
                       const bool is_node = ((ties >> (2 * axis)) & 0x41) == 0;
                       search_[i].word[axis] = is_node ? 0 : kNoNode;
                       num_nodes[chunk] += is_node;
                       if (is_node && with_evidence) {
                         const uint32_t low = Low({place, axis}).index;
                         capacity[chunk] += std::max<int64_t>(
                             0,
                             int64_t{FixedFaceEvidence(problem.evidence[i])} +
                                 FixedFaceEvidence(problem.evidence[low]));
                       }
                     }
                   });
                 });
  num_nodes_ = std::accumulate(num_nodes.begin(), num_nodes.end(), size_t{0});
  sink_capacity_ =
      std::accumulate(capacity.begin(), capacity.end(), int64_t{0});
}

void FlowState::InitVoxel(int32_t weight, FaceTies ties, size_t voxel) {
  FlowRecord& record = flows_[voxel];
  record.weight = weight;
  const int outside = ties & kAllFaces;
  const int inside = ties >> kNumFaces;
  const int tied = outside | inside;
  search_[voxel].residual = kFreeArcs[tied];
  if (tied == 0) {
    std::fill(std::begin(record.flow), std::end(record.flow), 0);
    return;
  }
  // From the source or into the sink; between two tied faces no node cares.
  for (int arc = 0; arc < kNumOctahedronArcs; ++arc) {
    if (kOctahedron.sign[arc] > 0) {
      const int head = kOctahedron.head[arc];
      const int from = ((outside >> (arc / 4)) & 1) | ((inside >> head) & 1);
      const int to = ((inside >> (arc / 4)) & 1) | ((outside >> head) & 1);
      record.flow[kOctahedron.edge[arc]] = (from - to) * weight;
    }
  }
}

int64_t FlowState::FlowValue(const Context& context) const {
  std::vector<int64_t> deficits(NumChunks(walk_.NumBricks(), kCutBrickGrain));
  ParallelChunks(context,
                 walk_.NumBricks(),
                 kCutBrickGrain,
                 [&](size_t chunk, size_t begin, size_t end) {
                   int64_t sum = 0;
                   walk_.ForEach(begin, end, [&](const VoxelPlace& place) {
                     for (uint32_t axis = 0; axis < 3; ++axis) {
                       if (search_[place.index].word[axis] != kNoNode) {
                         const FaceNode node{place, axis};
                         sum +=
                             std::min<int64_t>(0, Imbalance(node, Low(node)));
                       }
                     }
                   });
                   deficits[chunk] = sum;
                 });
  return std::accumulate(deficits.begin(), deficits.end(), sink_capacity_);
}

}  // namespace octacut
