// A flow to begin with: along straight lines through the crust.
//
// A line of voxels from a face tied outside to the opposite face of another,
// tied inside, carries as much as its weakest voxel: from face to face in the
// direction of the line by way of the four faces around. In crusts that is
// much of the maximum flow, at a small part of what searching costs.
#include <algorithm>
#include <array>
#include <type_traits>

#include "core/base/parallel.h"
#include "core/cut/cut_problem.h"
#include "core/cut/flow_state.h"

namespace octacut {
namespace {

constexpr int kNumWays = 4;  // through a voxel

// Into the way by the j-th face around, from face `from` of a voxel.
constexpr uint32_t WayIn(int from, int way) { return uint32_t(4 * from + way); }
// Out of it, to the opposite face.
constexpr uint32_t WayOut(int from, int way) {
  return kOctahedron.reverse[4 * OppositeFace(from) + way];
}

}  // namespace

// The longest are those of thick crusts; through the inside of an object, of
// hundreds of voxels, some are so weak that lines carry next to nothing.
template <typename Flow>
struct FlowState<Flow>::Line {
  static constexpr uint32_t kMostVoxels = 16;
  uint32_t size = 0;
  std::array<uint32_t, kMostVoxels> voxels;
  std::array<int32_t[kNumWays], kMostVoxels> ways;  // what each can take
};

template <typename Flow>
void FlowState<Flow>::PushAlongLines(std::span<const FaceTies> merged_ties,
                                     const Context& context) {
  // Lines of one axis share no voxel, so their order does not matter.
  const auto push = [&](auto axis) {
    const auto push_from = [&](const VoxelSlot& slot) {
      const FaceTies ties = merged_ties[slot.index];
      if (ties & OutsideTie(2 * axis())) {
        PushAlongLine<2 * axis()>(merged_ties, slot);
      }
      if (ties & OutsideTie(2 * axis() + 1)) {
        PushAlongLine<2 * axis() + 1>(merged_ties, slot);
      }
    };
    ParallelFor(context,
                walk_->NumBricks(),
                kCutBrickGrain,
                [&](size_t begin, size_t end) {
                  walk_->ForEach(begin, end, push_from);
                });
  };
  push(std::integral_constant<int, 0>());
  push(std::integral_constant<int, 1>());
  push(std::integral_constant<int, 2>());
}

template <typename Flow>
template <int kFrom>
void FlowState<Flow>::PushAlongLine(std::span<const FaceTies> merged_ties,
                                    const VoxelSlot& first) {
  constexpr int kTo = OppositeFace(kFrom);
  Line line;
  FaceTies ties = 0;
  for (VoxelSlot slot = first;; slot = walk_->Step(slot, kTo)) {
    if (line.size == Line::kMostVoxels) {
      return;
    }
    ties = merged_ties[slot.index];
    line.voxels[line.size++] = slot.index;
    if (ties & (OutsideTie(kTo) | InsideTie(kTo))) {
      break;
    }
  }
  // A single voxel is full of what its ties saturate.
  if (line.size == 1 || (ties & InsideTie(kTo)) == 0) {
    return;
  }
  int64_t amount = kMaxFixedCapacity;
  for (uint32_t k = 0; k < line.size && amount > 0; ++k) {
    amount = std::min(amount,
                      MeasureWays<kFrom>(merged_ties[line.voxels[k]], line, k));
  }
  for (uint32_t k = 0; k < line.size && amount > 0; ++k) {
    PushThrough<kFrom>(line, k, amount);
  }
}

// What the four ways through a voxel of a line can take together. At its ends
// the arcs of tied faces are saturated, and their flow waits beside them.
template <typename Flow>
template <int kFrom>
int64_t FlowState<Flow>::MeasureWays(FaceTies ties,
                                     Line& line,
                                     uint32_t k) const {
  const uint32_t voxel = line.voxels[k];
  const int32_t weight = flows_[voxel].weight;
  int64_t sum = 0;
  for (int way = 0; way < kNumWays; ++way) {
    const int side = FaceAround(kFrom, way);
    const int32_t in = k == 0 ? weight : Capacity(voxel, WayIn(kFrom, way));
    const int32_t out =
        k + 1 == line.size ? weight : Capacity(voxel, WayOut(kFrom, way));
    const bool is_tied = ties & (OutsideTie(side) | InsideTie(side));
    line.ways[k][way] = is_tied ? 0 : std::min(in, out);
    sum += line.ways[k][way];
  }
  return sum;
}

template <typename Flow>
template <int kFrom>
void FlowState<Flow>::PushThrough(const Line& line,
                                  uint32_t k,
                                  int64_t amount) {
  const uint32_t voxel = line.voxels[k];
  const uint32_t blocked = Residual(voxel) >> kNumOctahedronArcs;
  for (int way = 0; way < kNumWays && amount > 0; ++way) {
    const int32_t part = int32_t(std::min<int64_t>(amount, line.ways[k][way]));
    if (part == 0) {
      continue;
    }
    amount -= part;
    if (k > 0) {
      Push(voxel, WayIn(kFrom, way), part);
    }
    if (k + 1 < line.size) {
      Push(voxel, WayOut(kFrom, way), part);
    }
  }
  // A push shows the arc back, be it blocked or not.
  const uint32_t shown = kFreeArcs[blocked] | blocked << kNumOctahedronArcs;
  SetResidual(voxel, Residual(voxel) & shown);
}

template void FlowState<int32_t>::PushAlongLines(std::span<const FaceTies>,
                                                 const Context&);
template void FlowState<int16_t>::PushAlongLines(std::span<const FaceTies>,
                                                 const Context&);

}  // namespace octacut
