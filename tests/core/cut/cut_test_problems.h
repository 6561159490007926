// Random cut problems on small crusts, and an exhaustive minimum cut.
#pragma once

#include <random>
#include <vector>

#include "core/cut/octahedral_cut.h"

namespace octacut {

// A problem together with the arrays it refers to.
struct OwnedCutProblem {
  VoxelGrid crust;
  std::vector<float> weights;
  std::vector<FaceTies> ties;
  std::vector<float> evidence;

  OctahedralCutProblem View() const {
    return {&crust, weights, ties, evidence};
  }
};

// Voxels with coordinates in [origin, origin + size).
std::vector<MortonCode> BoxCodes(const Eigen::Vector3i& origin,
                                 const Eigen::Vector3i& size);

struct RandomTieOptions {
  // Probability that a border face is tied inside; the rest is outside.
  double inside = 0.5;
  // Probability that a face between two voxels is tied (either way).
  double inner = 0.0;
};

// Weights of 1 and random ties; inner ties are stated by one voxel or both.
OwnedCutProblem TieRandomly(VoxelGrid crust,
                            const RandomTieOptions& options,
                            std::mt19937& random);

enum class WeightKind { kUniform, kEqual, kExtreme, kSpeckle };
void SetRandomWeights(WeightKind kind,
                      std::mt19937& random,
                      OwnedCutProblem& problem);
// Evidence in [-scale, scale]; one voxel in four has none.
void SetRandomEvidence(float scale,
                       std::mt19937& random,
                       OwnedCutProblem& problem);

// The minimum cut with the fewest source nodes by trying every labelling of
// the untied faces, of which there may be at most 20.
OctahedralCut ExhaustiveCut(const OctahedralCutProblem& problem);

}  // namespace octacut
