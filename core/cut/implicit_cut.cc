#include "core/cut/implicit_cut.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cut/cut_problem.h"
#include "core/cut/flow_state.h"
#include "core/cut/search_forest.h"

namespace octacut {
namespace {

// Labels of a voxel: its ties, and the sides its nodes are on.
FaceLabels LabelsOf(const FlowState& state,
                    const VoxelPlace& place,
                    FaceTies ties) {
  const auto records = state.SearchRecords();
  int labels = ties >> kNumFaces;
  const int tied = labels | (ties & kAllFaces);
  for (int face = 0; face < kNumFaces; ++face) {
    if ((tied >> face) & 1) {
      continue;
    }
    const uint32_t owner =
        state.Walk().Step(place, (face & 1) ? face : kNumFaces).index;
    const bool is_source =
        SearchForest::IsSource(records[owner].word[face / 2]);
    labels |= int(!is_source) << face;
  }
  return FaceLabels(labels);
}

// Also the closure sweep: no residual arc leaves the source side.
std::vector<FaceLabels> EmitLabels(const FlowState& state,
                                   std::span<const FaceTies> merged_ties,
                                   const Context& context) {
  std::vector<FaceLabels> labels(merged_ties.size());
  ParallelFor(
      context,
      state.Walk().NumBricks(),
      kCutBrickGrain,
      [&](size_t begin, size_t end) {
        state.Walk().ForEach(begin, end, [&](const VoxelPlace& place) {
          const uint32_t i = place.index;
          labels[i] = LabelsOf(state, place, merged_ties[i]);
          if (state.Residual(i) & kLeavingArcs[labels[i]]) {
            throw InvariantError("cut: a residual arc leaves the source side");
          }
        });
      });
  return labels;
}

}  // namespace

OctahedralCut SolveImplicitly(const OctahedralCutProblem& problem,
                              const VoxelWalk& walk,
                              const Context& context) {
  if (walk.NumBricks() > kMaxCutBricks) {
    throw InputError("cut problem: more bricks than the solver can number");
  }
  FlowState state(
      problem, walk, MergeFaceTies(problem, walk, context), context);
  {
    SearchForest forest(state, context);
    forest.Run();
  }
  OctahedralCut cut;
  cut.num_nodes = state.NumNodes();
  cut.cost_fixed_point = state.FlowValue(context);
  state.ReleaseFlows();
  cut.labels =
      EmitLabels(state, MergeFaceTies(problem, walk, context), context);
  return cut;
}

size_t EstimateImplicitCutBytes(size_t num_voxels, bool with_evidence) {
  // At 25 voxels a brick, and one node in two queued.
  const size_t per_voxel = FlowState::kBytesPerVoxel +
                           VoxelWalk::kBytesPerBrick / 25 +
                           (with_evidence ? sizeof(int32_t) : 0) + 3;
  return num_voxels * per_voxel + (size_t{1} << 20);
}

}  // namespace octacut
