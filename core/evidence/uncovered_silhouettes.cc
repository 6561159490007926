#include "core/evidence/uncovered_silhouettes.h"

#include <cstdint>

#include "core/base/parallel.h"
#include "core/evidence/silhouette_samples.h"
#include "core/grid/parallel_voxels.h"

namespace octacut {
namespace {

// The number of voxels of the hull on the ray of each sample of a view.
std::vector<uint16_t> CountVoxels(const ViewProjection& projection,
                                  const VoxelGrid& hull,
                                  const SampleMap& map) {
  std::vector<uint16_t> counts(map.Size());
  hull.ForEach([&](VoxelGrid::Index, MortonCode code) {
    const int sample =
        map.At(projection, VoxelCenter(DecodeMorton(code), hull.Level()));
    if (sample >= 0 && counts[sample] < UINT16_MAX) {
      ++counts[sample];
    }
  });
  return counts;
}

}  // namespace

UncoveredSilhouettes FindUncoveredSilhouettes(
    const ViewSet& views,
    const VoxelGrid& hull,
    const std::vector<FaceLabels>& labels,
    const Context& context) {
  const std::vector<SampleMap> maps = MapSamples(views, hull, labels, context);
  UncoveredSilhouettes found;
  found.shares.resize(hull.Size());
  const SampleCounts counts = CountSamples(maps);
  if (counts.num_uncovered == 0) {
    found.num_samples = counts.num_sure;
    return found;
  }
  std::vector<std::vector<uint16_t>> num_voxels(views.size());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    num_voxels[i] = CountVoxels(views[i].projection, hull, maps[i]);
  });
  for (size_t i = 0; i < maps.size(); ++i) {
    for (size_t s = 0; s < maps[i].Size(); ++s) {
      // No voxel of the hull: something else that a mask shows, or clipped.
      if (maps[i].is_sure[s] && num_voxels[i][s] > 0) {
        ++found.num_samples;
        found.num_uncovered += !maps[i].is_covered[s];
      }
    }
  }
  ParallelForVoxels(
      context, hull, [&](VoxelGrid::Index index, MortonCode code) {
        const Eigen::Vector3f center =
            VoxelCenter(DecodeMorton(code), hull.Level());
        for (size_t i = 0; i < views.size(); ++i) {
          const int sample = maps[i].At(views[i].projection, center);
          if (sample >= 0 && maps[i].IsUncovered(sample)) {
            found.shares[index] += 1 / float(num_voxels[i][sample]);
          }
        }
      });
  return found;
}

}  // namespace octacut
