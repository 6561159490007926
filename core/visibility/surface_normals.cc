#include "core/visibility/surface_normals.h"

#include "core/base/parallel.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

constexpr size_t kBrickGrain = 256;
constexpr size_t kVoxelGrain = 8192;
// Below this the gradient is rounding noise.
constexpr float kSmallestGradient = 1e-4f;

using NeighborValues = std::array<float, kNumFaces>;

// Values of the six neighbours; where there is none, what the tie says.
NeighborValues ValuesAcross(const std::vector<float>& values,
                            const std::vector<FaceTies>& ties,
                            const VoxelWalk& walk,
                            const VoxelSlot& slot) {
  NeighborValues result;
  for (int face = 0; face < kNumFaces; ++face) {
    const VoxelGrid::Index n = walk.Neighbor(slot, face);
    result[face] = n != VoxelGrid::kNone
                       ? values[n]
                       : ((ties[slot.index] & InsideTie(face)) ? 1.0f : 0.0f);
  }
  return result;
}

float MeanWith(float own, const NeighborValues& across) {
  float sum = own;
  for (const float value : across) {
    sum += value;
  }
  return sum / float(1 + kNumFaces);
}

Eigen::Vector3f OutwardNormal(const NeighborValues& across) {
  const Eigen::Vector3f outward(
      across[0] - across[1], across[2] - across[3], across[4] - across[5]);
  const float length = outward.norm();
  return length > kSmallestGradient ? Eigen::Vector3f(outward / length)
                                    : Eigen::Vector3f::Zero();
}

// What is within so many 6-neighbour steps of some voxels.
struct Rings {
  std::vector<VoxelSlot> slots;  // the nearer ones first
  std::vector<size_t> ends;      // of the slots within k steps, by k
};

Rings RingsAround(const VoxelWalk& walk,
                  std::span<const uint8_t> centers,
                  int num_steps) {
  Rings rings;
  std::vector<uint8_t> found(centers.begin(), centers.end());
  walk.ForEach(0, walk.NumBricks(), [&](const VoxelSlot& slot) {
    if (found[slot.index]) {
      rings.slots.push_back(slot);
    }
  });
  rings.ends = {rings.slots.size()};
  for (size_t k = 0; int(rings.ends.size()) <= num_steps;) {
    for (; k < rings.ends.back(); ++k) {
      const VoxelSlot from = rings.slots[k];
      for (int face = 0; face < kNumFaces; ++face) {
        const VoxelGrid::Index n = walk.Neighbor(from, face);
        if (n != VoxelGrid::kNone && !found[n]) {
          found[n] = 1;
          rings.slots.push_back(walk.Step(from, face));
        }
      }
    }
    rings.ends.push_back(rings.slots.size());
  }
  return rings;
}

}  // namespace

std::vector<Eigen::Vector3f> EstimateNormals(const VoxelGrid& voxels,
                                             const std::vector<FaceTies>& ties,
                                             const std::vector<float>& prior,
                                             int blur_steps,
                                             const Context& context,
                                             std::span<const uint8_t> wanted) {
  std::vector<float> values = prior;
  std::vector<float> blurred(values.size());
  const VoxelWalk walk(voxels, context);
  const Rings rings =
      wanted.empty() ? Rings() : RingsAround(walk, wanted, blur_steps);
  // Calls body(element, index, values across) for what is so near to what is
  // wanted; that itself has the slots of its normals.
  const auto for_all_within = [&](int num_steps, auto&& body) {
    const auto call = [&](size_t element, const VoxelSlot& slot) {
      body(element, slot.index, ValuesAcross(values, ties, walk, slot));
    };
    if (wanted.empty()) {
      ParallelFor(context,
                  walk.NumBricks(),
                  kBrickGrain,
                  [&](size_t begin, size_t end) {
                    walk.ForEach(begin, end, [&](const VoxelSlot& slot) {
                      call(slot.index, slot);
                    });
                  });
      return;
    }
    ParallelFor(context,
                rings.ends[size_t(num_steps)],
                kVoxelGrain,
                [&](size_t begin, size_t end) {
                  for (size_t k = begin; k < end; ++k) {
                    call(k, rings.slots[k]);
                  }
                });
  };
  // What is k steps away is needed until there are k steps left.
  for (int step = 0; step < blur_steps; ++step) {
    for_all_within(
        blur_steps - step,
        [&](size_t, VoxelGrid::Index index, const NeighborValues& across) {
          blurred[index] = MeanWith(values[index], across);
        });
    values.swap(blurred);
  }
  std::vector<Eigen::Vector3f> normals(wanted.empty() ? values.size()
                                                      : rings.ends.front());
  for_all_within(
      0, [&](size_t element, VoxelGrid::Index, const NeighborValues& across) {
        normals[element] = OutwardNormal(across);
      });
  return normals;
}

std::vector<float> SmoothPrior(const VoxelGrid& voxels,
                               const std::vector<FaceTies>& ties,
                               const std::vector<float>& prior,
                               int blur_steps,
                               const Context& context) {
  std::vector<float> values = prior;
  std::vector<float> blurred(values.size());
  const VoxelWalk walk(voxels, context);
  for (int step = 0; step < blur_steps; ++step) {
    ParallelFor(
        context, walk.NumBricks(), kBrickGrain, [&](size_t begin, size_t end) {
          walk.ForEach(begin, end, [&](const VoxelSlot& slot) {
            blurred[slot.index] = MeanWith(
                values[slot.index], ValuesAcross(values, ties, walk, slot));
          });
        });
    values.swap(blurred);
  }
  return values;
}

}  // namespace octacut
