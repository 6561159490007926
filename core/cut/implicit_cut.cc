#include "core/cut/implicit_cut.h"

#include <algorithm>
#include <memory>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cut/cut_problem.h"
#include "core/cut/flow_state.h"
#include "core/cut/region_search.h"
#include "core/cut/search_forest.h"
#include "core/cut/source_side.h"

namespace octacut {
namespace {

// Labels of a voxel: its ties, and the sides its nodes are on.
template <typename Flow>
FaceLabels LabelsOf(const FlowState<Flow>& state,
                    const VoxelSlot& slot,
                    FaceTies ties) {
  const auto records = state.SearchRecords();
  int labels = ties >> kNumFaces;
  const int tied = labels | (ties & kAllFaces);
  for (int face = 0; face < kNumFaces; ++face) {
    if ((tied >> face) & 1) {
      continue;
    }
    const uint32_t owner =
        state.Walk().Step(slot, (face & 1) ? face : kNumFaces).index;
    const bool is_source = IsSourceNode(records[owner].word[face / 2]);
    labels |= int(!is_source) << face;
  }
  return FaceLabels(labels);
}

// Also the closure sweep: no residual arc leaves the source side.
template <typename Flow>
std::vector<FaceLabels> EmitLabels(const FlowState<Flow>& state,
                                   std::span<const FaceTies> merged_ties,
                                   const Context& context) {
  std::vector<FaceLabels> labels(merged_ties.size());
  ParallelFor(
      context,
      state.Walk().NumBricks(),
      kCutBrickGrain,
      [&](size_t begin, size_t end) {
        state.Walk().ForEach(begin, end, [&](const VoxelSlot& slot) {
          const uint32_t i = slot.index;
          labels[i] = LabelsOf(state, slot, merged_ties[i]);
          if (state.Residual(i) & kLeavingArcs[labels[i]]) {
            throw InvariantError("cut: a residual arc leaves the source side");
          }
        });
      });
  return labels;
}

// Ranges of bricks of some `region_voxels` voxels, by their ends. They depend
// on the crust alone, whatever the number of threads.
std::vector<uint32_t> RegionEnds(const VoxelWalk& walk,
                                 uint32_t region_voxels) {
  std::vector<uint32_t> ends;
  uint32_t first = 0;
  for (uint32_t brick = 1; brick <= walk.NumBricks(); ++brick) {
    const uint32_t size = walk.FirstVoxelOrEnd(brick) - first;
    if (size >= region_voxels || brick == walk.NumBricks()) {
      ends.push_back(brick);
      first += size;
    }
  }
  return ends;
}

template <typename Flow>
using KeptFlows = std::unique_ptr<FlowState<Flow>>;

// The flow of the whole problem, every node's side in its word.
template <typename Flow>
KeptFlows<Flow> SearchAnew(const OctahedralCutProblem& problem,
                           const VoxelWalk& walk,
                           std::vector<FaceTies>& merged_ties,
                           const SearchPlan& plan,
                           const Context& context) {
  const std::vector<uint32_t> ends = RegionEnds(walk, plan.region_voxels);
  auto flows = std::make_unique<FlowState<Flow>>(
      problem, walk, merged_ties, ends, plan.scale, context);
  std::vector<FaceTies>().swap(merged_ties);
  RegionSearch<Flow>(*flows, ends, plan.observer, context).Run();
  return flows;
}

// The same from the flow of a part of its crust.
template <typename Flow>
void SearchOn(const OctahedralCutProblem& problem,
              const VoxelWalk& walk,
              std::vector<FaceTies>& merged_ties,
              std::span<const VoxelGrid::Brick> before,
              const Context& context,
              FlowState<Flow>& flows) {
  const std::vector<NodeId> changed =
      flows.GrowTo(problem, walk, merged_ties, before, context);
  std::vector<FaceTies>().swap(merged_ties);
  const Phase phase(context, "minimum cut of the grown crust");
  SearchForest<Flow> forest(flows, changed, context);
  forest.RunByNeighborhood();
}

// What a search goes on from, and where its own flows are left; null: neither.
template <typename Flow>
struct KeptSearch {
  std::span<const VoxelGrid::Brick> bricks;
  KeptFlows<Flow>* flows;
};

template <typename Flow>
OctahedralCut Solve(const OctahedralCutProblem& problem,
                    const VoxelWalk& walk,
                    std::vector<FaceTies>& merged_ties,
                    const SearchPlan& plan,
                    const Context& context,
                    const KeptSearch<Flow>& search) {
  KeptFlows<Flow>* const kept = search.flows;
  KeptFlows<Flow> flows;
  if (kept != nullptr && *kept != nullptr &&
      (*kept)->GoesOnWith(problem, plan.scale)) {
    flows = std::move(*kept);
    SearchOn(problem, walk, merged_ties, search.bricks, context, *flows);
  } else {
    if (kept != nullptr) {
      kept->reset();
    }
    flows = SearchAnew<Flow>(problem, walk, merged_ties, plan, context);
  }
  FloodSourceSide(*flows, plan.flood_bricks, context);
  OctahedralCut cut;
  cut.num_nodes = flows->NumNodes();
  cut.cost_fixed_point = flows->FlowValue(context);
  if (kept == nullptr) {
    flows->ReleaseFlows();
  }
  merged_ties = MergeFaceTies(problem, walk, context);
  cut.labels = EmitLabels(*flows, merged_ties, context);
  if (kept != nullptr) {
    *kept = std::move(flows);
  }
  return cut;
}

}  // namespace

ImplicitCutState::ImplicitCutState() = default;
ImplicitCutState::~ImplicitCutState() = default;

SearchPlan PlanSearch(std::span<const FaceTies> merged_ties,
                      const Context& context) {
  // Low faces that are tied: some three for every two columns through the
  // crust, so that their share tells how thick it is.
  const int64_t num_tied = ParallelSum(
      context,
      merged_ties.size(),
      kCutVoxelGrain,
      [&](size_t begin, size_t end) {
        int64_t sum = 0;
        for (const FaceTies ties : merged_ties.subspan(begin, end - begin)) {
          const int tied = ties | ties >> kNumFaces;
          sum += (tied & 1) + ((tied >> 2) & 1) + ((tied >> 4) & 1);
        }
        return sum;
      });
  const double thickness =
      1.5 * double(merged_ties.size()) / double(std::max<int64_t>(1, num_tied));
  // Some eight thicknesses wide, and not too large for a core's cache.
  SearchPlan plan;
  plan.region_voxels = uint32_t(
      std::clamp(64 * thickness * thickness * thickness, 16384.0, 32768.0));
  return plan;
}

OctahedralCut SolveImplicitly(const OctahedralCutProblem& problem,
                              const VoxelWalk& walk,
                              std::vector<FaceTies>& merged_ties,
                              const SearchPlan& plan,
                              const Context& context,
                              ImplicitCutState* state) {
  if (walk.NumBricks() > kMaxCutBricks) {
    throw InputError("cut problem: more bricks than the solver can number");
  }
  const auto solve = [&]<typename Flow>(KeptFlows<Flow>* kept) {
    KeptSearch<Flow> search{{}, kept};
    if (state != nullptr) {
      search.bricks = state->bricks;
    }
    return Solve(problem, walk, merged_ties, plan, context, search);
  };
  const bool is_narrow = plan.scale.shift != 0;
  if (state != nullptr && is_narrow) {
    state->flows.reset();  // of an earlier crust
  } else if (state != nullptr) {
    state->narrow_flows.reset();
  }
  OctahedralCut cut =
      is_narrow ? solve(state == nullptr ? nullptr : &state->narrow_flows)
                : solve(state == nullptr ? nullptr : &state->flows);
  if (state != nullptr) {
    state->bricks = problem.crust->Bricks();
  }
  return cut;
}

size_t EstimateImplicitCutBytes(size_t num_voxels,
                                bool with_evidence,
                                bool lean) {
  // At 30 voxels a brick, and one node in four queued.
  const size_t per_voxel = (lean ? FlowState<int16_t>::kBytesPerVoxel
                                 : FlowState<int32_t>::kBytesPerVoxel) +
                           VoxelWalk::kBytesPerBrick / 30 +
                           (with_evidence ? sizeof(int32_t) : 0) + 3;
  return num_voxels * per_voxel + (size_t{1} << 20);
}

}  // namespace octacut
