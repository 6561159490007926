#include "core/pipeline/undecided_surface.h"

#include <algorithm>
#include <cmath>

#include "core/base/ramp.h"
#include "core/consistency/local_agreement.h"
#include "core/grid/parallel_voxels.h"
#include "core/pipeline/coarser_surface.h"
#include "core/pipeline/voxel_terms.h"

namespace octacut {
namespace {

// Evidence that holds an undecided surface, units of the weights. A surface of
// unseen voxels that is bent with a radius of R voxels pulls with 8 / R * 0.06
// of these units: this holds it down to R = 2.5.
constexpr float kHoldingWeight = 0.2f;
// The same outside the border of the hull, and of mirrors inside of it: there,
// it holds plates of one voxel, whose faces cost 4 * 0.06 each.
constexpr float kBorderWeight = 0.5f;
// Depth in the hull, voxels, within which an undecided surface is let out to
// the hull's border: what a coarser level cannot tell from it.
constexpr float kNearHull = 2.5f;
// What is decided around a voxel: up to the first the hull is the better guess,
// from the second on the surface of the coarser level.
constexpr float kUndecidedAround = 0.5f;
constexpr float kDecidedAround = 0.9f;

// The share by which weights at the border of the hull are reduced
// (docs/experiments/convex_surfaces.md).
constexpr float kHullDiscount = 0.5f;

// Levels from which on photo-consistency sees texture that the depth sweep did
// not.
constexpr int kFinerLevels = 2;
// Confidence in depths from which on agreement at coarser levels counts in
// full.
constexpr float kEnoughConfidence = 0.5f;

// Of a voxel outside the border of the hull.
float BorderEvidence(float hull_depth) {
  return -kBorderWeight * std::min(-2 * hull_depth, 1.0f);
}

}  // namespace

Decision DecideByPhotographs(const Crust& crust,
                             const std::vector<float>& phi,
                             const VoxelValues& confidence,
                             const Context& context) {
  LocalAgreement agreement = EstimateLocalAgreement(crust.voxels, phi, context);
  Decision decision{std::move(agreement.near_voxel),
                    std::move(agreement.in_region)};
  // Where depths contradict each other or are few, agreement here and there is
  // chance; not so where it is the rule, but for images that are hardly finer
  // than those in which the depths were looked for: on those, the shading of a
  // plain surface agrees at any depth.
  const bool is_coarse =
      crust.voxels.Level() < confidence.voxels.Level() + kFinerLevels;
  ParallelForVoxels(
      context, crust.voxels, [&](VoxelGrid::Index index, MortonCode code) {
        float& around = decision.around[index];
        const float given = confidence.At(code, crust.voxels.Level(), around);
        around = is_coarse ? std::min(given / kEnoughConfidence, 1.0f)
                           : std::max(around, given);
        decision.here[index] *= around;
      });
  return decision;
}

double DecidedShare(const std::vector<FaceLabels>& labels,
                    const Decision& decision) {
  double sum = 0;
  size_t count = 0;
  for (size_t i = 0; i < labels.size(); ++i) {
    if (IsCut(labels[i])) {
      sum += decision.here[i];
      ++count;
    }
  }
  return sum / double(std::max<size_t>(count, 1));
}

std::vector<float> DecidedWeights(const Decision& decision,
                                  const std::vector<float>& phi,
                                  const ReconstructionOptions& options) {
  const float unseen = NeutralWeight(options);
  std::vector<float> weights = EdgeWeights(phi, options.energy);
  for (size_t i = 0; i < weights.size(); ++i) {
    weights[i] = unseen + decision.here[i] * (weights[i] - unseen);
  }
  return weights;
}

void FavorHullBorder(const Decision& decision,
                     const std::vector<float>& hull_depth,
                     std::vector<float>* weights) {
  for (size_t i = 0; i < weights->size(); ++i) {
    const float nearness = std::max(0.0f, 1 - std::abs(hull_depth[i]));
    (*weights)[i] *= 1 - kHullDiscount * decision.here[i] * nearness;
  }
}

void HoldHull(const std::vector<float>& hull_depth,
              std::vector<float>* evidence) {
  for (size_t i = 0; i < evidence->size(); ++i) {
    (*evidence)[i] +=
        hull_depth[i] < 0 ? BorderEvidence(hull_depth[i]) : kBorderWeight;
  }
}

void HoldUndecidedSurface(const Crust& crust,
                          const Decision& decision,
                          const std::vector<float>& hull_depth,
                          const Context& context,
                          std::vector<float>* evidence) {
  const std::vector<float> inside = CoarserInside(crust, context);
  for (size_t i = 0; i < evidence->size(); ++i) {
    const float undecided = 1 - decision.here[i];
    if (hull_depth[i] < 0) {
      (*evidence)[i] += undecided * BorderEvidence(hull_depth[i]);
      continue;
    }
    float side = 2 * inside[i] - 1;  // of the coarser surface, -1 .. 1
    if (hull_depth[i] < kNearHull) {
      const float decided =
          Ramp(decision.around[i], kUndecidedAround, kDecidedAround);
      side += (1 - decided) * (1 - side);
    }
    (*evidence)[i] += kHoldingWeight * undecided * side;
  }
}

}  // namespace octacut
