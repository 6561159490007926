#include "core/cut/source_side.h"

#include <array>
#include <bit>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/cut/bucket_queue.h"

namespace octacut {
namespace {

constexpr int32_t kLevel = 1;  // the queue has one

using Lists = std::array<std::vector<NodeId>, 3>;  // by axis

// A flood that stays in a range of bricks, whose words no other thread reads.
template <typename Flow>
class RangeFlood {
 public:
  RangeFlood(FlowState<Flow>& state, size_t begin, size_t end)
      : state_(state), begin_(uint32_t(begin)), size_(uint32_t(end - begin)) {}

  void AddSources() {
    const auto records = state_.SearchRecords();
    const auto add = [&](const VoxelSlot& slot) {
      for (uint32_t axis = 0; axis < 3; ++axis) {
        if (records[slot.index].word[axis] == kSourceNode) {
          Add(axis, IdOf(slot));
        }
      }
    };
    state_.Walk().ForEach(begin_, begin_ + size_, add);
  }
  void Add(uint32_t axis, NodeId id) { queue_.Add(kLevel, axis, id, pool_); }

  void Run(const Context& context) {
    while (!queue_.Empty()) {
      context.ThrowIfCancelled();
      queue_.Consume(
          kLevel,
          pool_,
          [&](auto axis, NodeId id) {
            state_.template PrefetchSearch<axis()>(id);
          },
          [&](auto axis, NodeId id) {
            Scan(id, state_.template Node<axis()>(id));
          });
    }
  }

  // Nodes with residual arcs to nodes out of the range.
  Lists& Leaving() { return leaving_; }

 private:
  bool Holds(uint32_t brick) const { return brick - begin_ < size_; }

  // The arcs of a node whose other ends lie in the range.
  template <int kAxis>
  uint32_t ArcsInside(const AxisNode<kAxis>& node) const {
    constexpr int kNext = 2 * ((kAxis + 1) % 3) + 1;
    constexpr int kLast = 2 * ((kAxis + 2) % 3) + 1;
    const VoxelWalk& walk = state_.Walk();
    const auto arcs = [&](uint32_t codes, uint32_t brick) {
      return Holds(brick) ? codes : 0;
    };
    return 0x05u | arcs(0x02, walk.StepBrick(node.slot, kNext)) |
           arcs(0x08, walk.StepBrick(node.slot, kLast)) |
           arcs(0x50, node.low.brick) |
           arcs(0x20, walk.StepBrick(node.low, kNext)) |
           arcs(0x80, walk.StepBrick(node.low, kLast));
  }

  template <int kAxis>
  void Scan(NodeId id, const AxisNode<kAxis>& node) {
    const uint32_t residual = state_.ResidualOut(node);
    uint32_t arcs = residual & ArcsInside(node);
    if (arcs != residual) {
      leaving_[kAxis].push_back(id);
    }
    const WordsAround words = state_.Around(node, arcs);
    for (arcs &= words.Equal(kFreeNode); arcs != 0; arcs &= arcs - 1) {
      const FaceNode other = state_.Across(node, std::countr_zero(arcs));
      state_.Word(other) = kReachedNode;
      Add(other.axis, IdOf(other.slot));
    }
  }

  FlowState<Flow>& state_;
  uint32_t begin_, size_;  // bricks
  ChunkPool pool_;
  BucketQueue queue_;
  Lists leaving_;
};

}  // namespace

template <typename Flow>
void FloodSourceSide(FlowState<Flow>& state,
                     uint32_t range_bricks,
                     const Context& context) {
  const size_t num_bricks = state.Walk().NumBricks();
  std::vector<Lists> leaving(NumChunks(num_bricks, range_bricks));
  ParallelChunks(context,
                 num_bricks,
                 range_bricks,
                 [&](size_t chunk, size_t begin, size_t end) {
                   RangeFlood<Flow> flood(state, begin, end);
                   flood.AddSources();
                   flood.Run(context);
                   leaving[chunk] = std::move(flood.Leaving());
                 });
  // What is reached from other ranges alone is little, and flooded last.
  RangeFlood<Flow> flood(state, 0, num_bricks);
  for (const Lists& lists : leaving) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
      for (const NodeId id : lists[axis]) {
        flood.Add(axis, id);
      }
    }
    flood.Run(context);
  }
}

template void FloodSourceSide(FlowState<int32_t>&, uint32_t, const Context&);
template void FloodSourceSide(FlowState<int16_t>&, uint32_t, const Context&);

}  // namespace octacut
