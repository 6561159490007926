// Checks of a cut problem, and the two quantities every solver and proof
// derives from it: the ties of shared faces and the cost of a labelling. `walk`
// is always that of the problem's crust.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/cut/fixed_point.h"
#include "core/cut/octahedral_cut.h"
#include "core/cut/octahedron.h"
#include "core/grid/voxel_walk.h"

namespace octacut {

// Bricks a task handles at once: some ten thousand voxels.
inline constexpr size_t kCutBrickGrain = 512;
// Voxels, where a task does next to nothing for each.
inline constexpr size_t kCutVoxelGrain = size_t{1} << 16;

// Throws InputError unless sizes agree and every weight and evidence is
// finite and in the range of fixed_point.h.
void CheckCutValues(const OctahedralCutProblem& problem,
                    const Context& context);

// The ties of every voxel with those its neighbours state of shared faces.
// Throws InputError for a face tied both ways or an untied border face.
std::vector<FaceTies> MergeFaceTies(const OctahedralCutProblem& problem,
                                    const VoxelWalk& walk,
                                    const Context& context);

// Cost of a labelling in units of the scale, from the definition: w for each of
// a voxel's twelve edges whose faces differ, and for each untied face the
// evidence it is labelled against; the evidence of a face between two voxels
// is the signed sum of their shares. `merged_ties` as of MergeFaceTies.
// Throws InvariantError when two voxels disagree on a face or a label
// contradicts a tie.
int64_t LabellingCost(const OctahedralCutProblem& problem,
                      const VoxelWalk& walk,
                      std::span<const FaceTies> merged_ties,
                      std::span<const FaceLabels> labels,
                      const CutScale& scale,
                      const Context& context);

// Number of cut edges of a voxel with these labels: pairs of faces that are
// not opposite and differ.
inline constexpr std::array<uint8_t, 64> MakeNumCutEdges() {
  std::array<uint8_t, 64> number = {};
  for (int labels = 0; labels < 64; ++labels) {
    number[labels] = uint8_t(std::popcount(kLeavingArcs[labels]));
  }
  return number;
}
inline constexpr std::array<uint8_t, 64> kNumCutEdges = MakeNumCutEdges();
inline int NumCutEdges(FaceLabels labels) { return kNumCutEdges[labels]; }

}  // namespace octacut
