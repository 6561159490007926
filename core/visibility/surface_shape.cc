#include "core/visibility/surface_shape.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

constexpr size_t kBrickGrain = 256;
constexpr size_t kVoxelGrain = 8192;
// Below this the gradient is rounding noise.
constexpr float kSmallestGradient = 1e-4f;
// 1/voxel: more is the noise of voxels, a ball of some two voxels is not shown
// by blurred values.
constexpr float kLargestCurvature = 0.4f;
// The cosine between the normals of neighbours of one surface of at most that
// curvature, a cylinder. Normals that differ more are of the two sides of thin
// matter, or of none.
constexpr float kSameSide = 0.7f;

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

// Half of the divergence of the normals around a voxel. Where there is no
// neighbour on the same side of the object, the normal is taken to go on as it
// is.
float MeanCurvature(const std::vector<Eigen::Vector3f>& normals,
                    const VoxelWalk& walk,
                    const VoxelSlot& slot) {
  float divergence = 0;
  for (int axis = 0; axis < 3; ++axis) {
    float difference = 0;
    int num_steps = 0;
    for (const int side : {0, 1}) {
      const VoxelGrid::Index n = walk.Neighbor(slot, 2 * axis + side);
      if (n != VoxelGrid::kNone &&
          normals[n].dot(normals[slot.index]) > kSameSide) {
        const float step = normals[n][axis] - normals[slot.index][axis];
        difference += side == 0 ? -step : step;
        ++num_steps;
      }
    }
    divergence += num_steps > 0 ? difference / float(num_steps) : 0;
  }
  return std::clamp(divergence / 2, -kLargestCurvature, kLargestCurvature);
}

template <typename Body>
void ForEachSlot(const VoxelWalk& walk, const Context& context, Body&& body) {
  ParallelFor(
      context, walk.NumBricks(), kBrickGrain, [&](size_t begin, size_t end) {
        walk.ForEach(begin, end, body);
      });
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

std::vector<float> SmoothPrior(const VoxelGrid& voxels,
                               const std::vector<FaceTies>& ties,
                               const std::vector<float>& prior,
                               int blur_steps,
                               const Context& context) {
  std::vector<float> values = prior;
  std::vector<float> blurred(values.size());
  const VoxelWalk walk(voxels, context);
  for (int step = 0; step < blur_steps; ++step) {
    ForEachSlot(walk, context, [&](const VoxelSlot& slot) {
      blurred[slot.index] =
          MeanWith(values[slot.index], ValuesAcross(values, ties, walk, slot));
    });
    values.swap(blurred);
  }
  return values;
}

std::vector<SurfaceShape> EstimateSurfaceShape(
    const VoxelGrid& voxels,
    const std::vector<FaceTies>& ties,
    const std::vector<float>& prior,
    int blur_steps,
    const Context& context,
    std::span<const uint8_t> wanted) {
  const VoxelWalk walk(voxels, context);
  const Rings rings =
      wanted.empty() ? Rings() : RingsAround(walk, wanted, blur_steps + 1);
  // Calls body(element, slot) for what is so near to what is wanted; that
  // itself has the slots of its shapes.
  const auto for_all_within = [&](int num_steps, auto&& body) {
    if (wanted.empty()) {
      ForEachSlot(walk, context, [&](const VoxelSlot& slot) {
        body(slot.index, slot);
      });
      return;
    }
    ParallelEach(
        context, rings.ends[size_t(num_steps)], kVoxelGrain, [&](size_t k) {
          body(k, rings.slots[k]);
        });
  };
  std::vector<float> values = prior;
  std::vector<float> blurred(values.size());
  // What is k steps away is needed until there are k - 1 steps left, since
  // curvature looks at the normals beside a voxel.
  for (int step = 0; step < blur_steps; ++step) {
    for_all_within(blur_steps + 1 - step, [&](size_t, const VoxelSlot& slot) {
      blurred[slot.index] =
          MeanWith(values[slot.index], ValuesAcross(values, ties, walk, slot));
    });
    values.swap(blurred);
  }
  std::vector<Eigen::Vector3f> normals(values.size());
  for_all_within(1, [&](size_t, const VoxelSlot& slot) {
    normals[slot.index] = OutwardNormal(ValuesAcross(values, ties, walk, slot));
  });
  std::vector<SurfaceShape> shapes(wanted.empty() ? values.size()
                                                  : rings.ends.front());
  for_all_within(0, [&](size_t element, const VoxelSlot& slot) {
    shapes[element] = {normals[slot.index], MeanCurvature(normals, walk, slot)};
  });
  return shapes;
}

}  // namespace octacut
