// The search on several threads: regions of the crust alone, then joined.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/context.h"
#include "core/base/parallel.h"
#include "core/cut/flow_state.h"
#include "core/cut/implicit_cut.h"
#include "core/cut/search_forest.h"

namespace octacut {

// Searches regions and joins them pairwise, bottom up: the thread that finishes
// the second half of a join goes on with the join.
template <typename Flow>
class RegionSearch {
 public:
  RegionSearch(FlowState<Flow>& state,
               std::span<const uint32_t> ends,
               const SearchObserver& observer,
               const Context& context)
      : state_(state), ends_(ends), observer_(observer), context_(context) {
    if (!ends_.empty()) {
      first_slots_.resize(ends_.size());
      joins_ = std::make_unique<Join[]>(ends_.size() - 1);
      PlanJoins(0, ends_.size(), {});
    }
  }

  // Leaves the side of every node in its word.
  void Run() {
    if (ends_.empty()) {
      return;
    }
    Phase phase(context_, "minimum cut", total_work_);
    ParallelFor(context_, ends_.size(), 1, [&](size_t region, size_t) {
      RunFrom(region, phase);
    });
  }

 private:
  using Forest = std::unique_ptr<SearchForest<Flow>>;
  // Where a searched range goes: one half of a join, or nowhere further.
  struct Join;
  struct Slot {
    Join* join = nullptr;
    int half = 0;
  };
  struct Join {
    size_t begin = 0, end = 0;  // regions
    Slot slot;
    Forest halves[2];
    std::atomic<int> num_missing = 2;
  };

  void PlanJoins(size_t begin, size_t end, Slot slot) {
    total_work_ += Work(begin, end);
    if (end - begin == 1) {
      first_slots_[begin] = slot;
      return;
    }
    Join& join = joins_[num_joins_++];
    join.begin = begin;
    join.end = end;
    join.slot = slot;
    PlanJoins(begin, (begin + end) / 2, {&join, 0});
    PlanJoins((begin + end) / 2, end, {&join, 1});
  }

  // On crusts a level of joins takes a twentieth of what the regions take
  // alone.
  size_t Work(size_t begin, size_t end) const {
    const size_t num_voxels =
        state_.Walk().FirstVoxelOrEnd(ends_[end - 1]) -
        state_.Walk().FirstVoxelOrEnd(begin == 0 ? 0 : ends_[begin - 1]);
    return end - begin == 1 ? num_voxels : num_voxels / 20;
  }

  void RunFrom(size_t region, Phase& phase) {
    Forest forest = Search(region, region + 1, phase, [&] {
      const uint32_t begin = region == 0 ? 0 : ends_[region - 1];
      return std::make_unique<SearchForest<Flow>>(
          state_, begin, ends_[region], context_);
    });
    Slot slot = first_slots_[region];
    while (slot.join != nullptr) {
      Join& join = *slot.join;
      join.halves[slot.half] = std::move(forest);
      if (--join.num_missing > 0) {
        return;
      }
      forest = Search(join.begin, join.end, phase, [&] {
        join.halves[0]->Absorb(*join.halves[1]);
        join.halves[1].reset();
        return std::move(join.halves[0]);
      });
      slot = join.slot;
    }
  }

  template <typename MakeForest>
  Forest Search(size_t begin, size_t end, Phase& phase, MakeForest&& make) {
    const auto observe = [&](bool begins) {
      if (observer_) {
        observer_(begin, end, begins);
      }
    };
    observe(true);
    Forest forest = make();
    forest->Run();
    observe(false);
    phase.Advance(Work(begin, end));
    return forest;
  }

  FlowState<Flow>& state_;
  std::span<const uint32_t> ends_;
  const SearchObserver& observer_;
  const Context& context_;
  std::vector<Slot> first_slots_;  // of each region
  std::unique_ptr<Join[]> joins_;
  size_t num_joins_ = 0;
  size_t total_work_ = 0;
};

}  // namespace octacut
