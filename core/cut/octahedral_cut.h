// Minimum cut of the octahedral graph of a crust [HK06 section 4]: one node
// per voxel face, twelve undirected edges inside each voxel that join every
// two faces that are not opposite, all of the voxel's weight.
//
// The outside is the source, the inside the sink. This header is all that the
// rest of octacut knows of the solver behind it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

struct OctahedralCutProblem {
  const VoxelGrid* crust = nullptr;
  // psi(phi(v)) + a of every voxel; > 0 and at most 1023. The solver works
  // on round(w * 2^20), at least 1.
  std::span<const float> weights;
  // One per voxel. A face without a crust voxel on its other side must be tied.
  std::span<const FaceTies> ties;
  // Evidence of every voxel: > 0 speaks for inside, < 0 for outside; empty
  // for none. A cut pays |evidence| / 6 for each face of the voxel that it
  // labels against it, so a face between two voxels sums theirs
  // (signed: opposite evidence cancels) and tied faces pay nothing. Same unit
  // and fixed-point scale as the weights; at most 6 * 1023 in magnitude.
  std::span<const float> evidence;
};

struct OctahedralCut {
  // One per voxel of the crust: bit f set = face f inside. Two voxels that
  // share a face agree on it. Among all minimum cuts it is the one with the
  // fewest nodes on the source (outside) side, which is unique.
  std::vector<FaceLabels> labels;
  // Cost of the cut in units of 2^-20, evidence included; equals the maximum
  // flow, unless the cut is a lean one.
  int64_t cost_fixed_point = 0;
  double cost = 0;       // the same in units of the weights
  size_t num_nodes = 0;  // faces that are not tied
  size_t num_cut_voxels = 0;
};

struct OctahedralCutOptions {
  // Called with every problem before it is solved; to store it, for example.
  std::function<void(const OctahedralCutProblem&)> observer = nullptr;

  // Narrow flows: weights of 14 bits, some 25 bytes per voxel less. The labels
  // are a minimum cut of the rounded weights; `cost` is still theirs under the
  // exact ones, some hundredths of a percent above the least one.
  bool lean = false;
};

struct ImplicitCutState;

// What a cut leaves behind for the next one, of a crust that has grown: some 70
// bytes per voxel (45 of a lean cut).
class OctahedralCutState {
 public:
  OctahedralCutState();
  ~OctahedralCutState();
  OctahedralCutState(OctahedralCutState&&) noexcept;
  OctahedralCutState& operator=(OctahedralCutState&&) noexcept;

 private:
  friend OctahedralCut SolveOctahedralCut(const OctahedralCutProblem&,
                                          const OctahedralCutOptions&,
                                          const Context&,
                                          OctahedralCutState*);
  std::unique_ptr<ImplicitCutState> state_;
};

// Throws InputError on a malformed problem (sizes that differ, weights that
// are not positive or above 1023, an untied border face, a face tied both
// ways), InvariantError when the run-time proof fails (a residual arc that
// leaves the source side, or cost != flow).
//
// With a `state` the search goes on from that of the last cut, and its own is
// left there: the same cut as without, at a part of the time where little has
// changed. Its crust must be part of the problem's, else InputError is thrown;
// weights, ties and evidence may be any.
OctahedralCut SolveOctahedralCut(const OctahedralCutProblem& problem,
                                 const OctahedralCutOptions& options,
                                 const Context& context,
                                 OctahedralCutState* state = nullptr);

// Bytes that SolveOctahedralCut will need at its peak, besides its input.
size_t EstimateOctahedralCutBytes(size_t num_voxels,
                                  bool with_evidence,
                                  bool lean = false);

}  // namespace octacut
