#include "core/consistency/local_agreement.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/base/ramp.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

constexpr size_t kAgreementGrain = 256;
// Averagings of phi over the six neighbours, and steps to them within which
// the least mean counts: somewhat more than half of a crust of six voxels.
// (docs/experiments/undecided_surface.md)
constexpr int kMeanSteps = 2;
constexpr int kReach = 4;
// Means of phi: up to the first the views agree, from the second on they do
// not. Neutral is 0.5.
constexpr float kSurePhi = 0.3f;
constexpr float kDoubtfulPhi = 0.45f;
// Shares of a region that agree, likewise.
constexpr float kDoubtfulRegion = 0.3f;
constexpr float kSureRegion = 0.6f;
constexpr int kBrickSteps = 3;

// Replaces each value by combine(itself, indices of its neighbours).
template <typename Combine>
void OverNeighbors(const VoxelWalk& walk,
                   const Context& context,
                   const Combine& combine,
                   std::vector<float>* values) {
  std::vector<float> result(values->size());
  ParallelFor(
      context,
      walk.NumBricks(),
      kAgreementGrain,
      [&](size_t begin, size_t end) {
        walk.ForEachWithNeighbors(
            begin, end, [&](const VoxelSlot& slot, const auto& neighbors) {
              result[slot.index] = combine((*values)[slot.index], neighbors);
            });
      });
  values->swap(result);
}

// The least of the means of phi near each voxel.
std::vector<float> LeastMeans(const VoxelWalk& walk,
                              const std::vector<float>& phi,
                              const Context& context) {
  std::vector<float> values = phi;
  const auto mean = [&](float own, const auto& neighbors) {
    float sum = own;
    int count = 1;
    for (const VoxelWalk::Index n : neighbors) {
      if (n != VoxelGrid::kNone) {
        sum += values[n];
        ++count;
      }
    }
    return sum / float(count);
  };
  const auto least = [&](float own, const auto& neighbors) {
    for (const VoxelWalk::Index n : neighbors) {
      own = n == VoxelGrid::kNone ? own : std::min(own, values[n]);
    }
    return own;
  };
  for (int i = 0; i < kMeanSteps; ++i) {
    OverNeighbors(walk, context, mean, &values);
  }
  for (int i = 0; i < kReach; ++i) {
    OverNeighbors(walk, context, least, &values);
  }
  return values;
}

std::vector<float> AgreementOfRegions(const VoxelWalk& walk,
                                      const std::vector<float>& near_voxel) {
  std::vector<float> sums(walk.NumBricks());
  std::vector<float> counts(walk.NumBricks());
  for (size_t b = 0; b < walk.NumBricks(); ++b) {
    for (uint32_t i = walk.FirstVoxelOrEnd(b); i < walk.FirstVoxelOrEnd(b + 1);
         ++i) {
      sums[b] += near_voxel[i];
      counts[b] += 1;
    }
  }
  for (int step = 0; step < kBrickSteps; ++step) {
    sums = walk.SumOverBrickNeighbors(sums);
    counts = walk.SumOverBrickNeighbors(counts);
  }
  std::vector<float> in_region(near_voxel.size());
  for (size_t b = 0; b < walk.NumBricks(); ++b) {
    const float value = Ramp(sums[b] / counts[b], kDoubtfulRegion, kSureRegion);
    std::fill(in_region.begin() + walk.FirstVoxelOrEnd(b),
              in_region.begin() + walk.FirstVoxelOrEnd(b + 1),
              value);
  }
  return in_region;
}

}  // namespace

LocalAgreement EstimateLocalAgreement(const VoxelGrid& voxels,
                                      const std::vector<float>& phi,
                                      const Context& context) {
  const VoxelWalk walk(voxels, context);
  LocalAgreement agreement{LeastMeans(walk, phi, context), {}};
  for (float& value : agreement.near_voxel) {
    value = Ramp(value, kDoubtfulPhi, kSurePhi);
  }
  agreement.in_region = AgreementOfRegions(walk, agreement.near_voxel);
  return agreement;
}

}  // namespace octacut
