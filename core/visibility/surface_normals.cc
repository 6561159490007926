#include "core/visibility/surface_normals.h"

#include "core/base/parallel.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

constexpr size_t kBrickGrain = 256;
// Below this the gradient is rounding noise.
constexpr float kSmallestGradient = 1e-4f;

using NeighborValues = std::array<float, kNumFaces>;

// Values of the six neighbours; where there is none, what the tie says.
NeighborValues ValuesAcross(const std::vector<float>& values,
                            const std::vector<FaceTies>& ties,
                            const VoxelWalk& walk,
                            const VoxelPlace& place) {
  NeighborValues result;
  for (int face = 0; face < kNumFaces; ++face) {
    const VoxelGrid::Index n = walk.Neighbor(place, face);
    result[face] = n != VoxelGrid::kNone
                       ? values[n]
                       : ((ties[place.index] & InsideTie(face)) ? 1.0f : 0.0f);
  }
  return result;
}

}  // namespace

std::vector<Eigen::Vector3f> EstimateNormals(const VoxelGrid& voxels,
                                             const std::vector<FaceTies>& ties,
                                             const std::vector<float>& prior,
                                             int blur_steps,
                                             const Context& context) {
  std::vector<float> values = prior;
  std::vector<float> blurred(values.size());
  const VoxelWalk walk(voxels);
  const auto for_all = [&](auto&& body) {
    ParallelFor(
        context, walk.NumBricks(), kBrickGrain, [&](size_t begin, size_t end) {
          walk.ForEach(begin, end, [&](const VoxelPlace& place) {
            body(place.index, ValuesAcross(values, ties, walk, place));
          });
        });
  };
  for (int step = 0; step < blur_steps; ++step) {
    for_all([&](VoxelGrid::Index index, const NeighborValues& across) {
      float sum = values[index];
      for (const float value : across) {
        sum += value;
      }
      blurred[index] = sum / 7;
    });
    values.swap(blurred);
  }
  std::vector<Eigen::Vector3f> normals(values.size());
  for_all([&](VoxelGrid::Index index, const NeighborValues& across) {
    const Eigen::Vector3f outward(
        across[0] - across[1], across[2] - across[3], across[4] - across[5]);
    const float length = outward.norm();
    normals[index] = length > kSmallestGradient
                         ? Eigen::Vector3f(outward / length)
                         : Eigen::Vector3f::Zero();
  });
  return normals;
}

}  // namespace octacut
