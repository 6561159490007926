#include "core/evidence/uncovered_silhouettes.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/grid/parallel_voxels.h"

namespace octacut {
namespace {

// Half the side of a voxel's footprint, in samples: more than half the
// diagonal of a face, so that no ray slips between voxels of matter.
constexpr float kReach = 0.75f;

// A view in samples that are one hull voxel wide.
struct SampleMap {
  int width = 0;
  int height = 0;
  float scale = 1;  // samples a pixel
  std::vector<uint8_t> is_uncovered;
  std::vector<uint16_t> num_voxels;  // of the hull on the sample's ray
  size_t num_samples = 0;
  size_t num_uncovered = 0;

  // The sample of a point; -1 when it is out of the frame or behind.
  int At(const ViewProjection& projection, const Eigen::Vector3f& point) const {
    const std::optional<ProjectedPoint> p = projection.ProjectIntoFrame(point);
    if (!p) {
      return -1;
    }
    const int x = std::min(int(p->u * scale), width - 1);
    const int y = std::min(int(p->v * scale), height - 1);
    return y * width + x;
  }
};

void MarkCovered(const ViewProjection& projection,
                 const Eigen::Vector3f& center,
                 const SampleMap& map,
                 std::vector<uint8_t>* is_covered) {
  const std::optional<ProjectedPoint> p = projection.Project(center);
  if (!p) {
    return;
  }
  const float x = p->u * map.scale;
  const float y = p->v * map.scale;
  const int x0 = std::max(0, int(x - kReach));
  const int y0 = std::max(0, int(y - kReach));
  const int x1 = std::min(map.width - 1, int(x + kReach));
  const int y1 = std::min(map.height - 1, int(y + kReach));
  for (int row = y0; row <= y1; ++row) {
    for (int column = x0; column <= x1; ++column) {
      (*is_covered)[size_t(row) * map.width + column] = 1;
    }
  }
}

SampleMap FindUncoveredSamples(const PreparedView& view,
                               const VoxelGrid& hull,
                               const std::vector<FaceLabels>& labels) {
  const ViewProjection& projection = view.projection;
  SampleMap map;
  map.scale = std::min(
      1.0f, 1 / projection.CenterFootprint(1.0f / float(hull.Resolution())));
  map.width = std::max(1, int(float(projection.width) * map.scale));
  map.height = std::max(1, int(float(projection.height) * map.scale));
  map.num_voxels.resize(size_t(map.width) * map.height);
  map.is_uncovered.resize(map.num_voxels.size());
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      map.is_uncovered[size_t(y) * map.width + x] =
          view.silhouette.Test(float(x - 1) / map.scale,
                               float(y - 1) / map.scale,
                               float(x + 2) / map.scale,
                               float(y + 2) / map.scale) == Footprint::kObject;
    }
  }
  std::vector<uint8_t> is_covered(map.is_uncovered.size());
  hull.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const Eigen::Vector3f center =
        VoxelCenter(DecodeMorton(code), hull.Level());
    const int sample = map.At(projection, center);
    if (sample >= 0 && map.num_voxels[sample] < UINT16_MAX) {
      ++map.num_voxels[sample];
    }
    if (labels[index] != 0) {
      MarkCovered(projection, center, map, &is_covered);
    }
  });
  for (size_t i = 0; i < is_covered.size(); ++i) {
    // No voxel of the hull: something else that a mask shows, or clipped.
    const bool is_sample = map.is_uncovered[i] && map.num_voxels[i] > 0;
    map.is_uncovered[i] = is_sample && !is_covered[i];
    map.num_samples += is_sample;
    map.num_uncovered += map.is_uncovered[i];
  }
  return map;
}

}  // namespace

UncoveredSilhouettes FindUncoveredSilhouettes(
    const ViewSet& views,
    const VoxelGrid& hull,
    const std::vector<FaceLabels>& labels,
    const Context& context) {
  std::vector<SampleMap> maps(views.size());
  ParallelFor(context, views.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      maps[i] = FindUncoveredSamples(views[i], hull, labels);
    }
  });
  UncoveredSilhouettes found;
  for (const SampleMap& map : maps) {
    found.num_samples += map.num_samples;
    found.num_uncovered += map.num_uncovered;
  }
  found.shares.resize(hull.Size());
  ParallelForVoxels(
      context, hull, [&](VoxelGrid::Index index, MortonCode code) {
        const Eigen::Vector3f center =
            VoxelCenter(DecodeMorton(code), hull.Level());
        for (size_t i = 0; i < views.size(); ++i) {
          const int sample = maps[i].At(views[i].projection, center);
          if (sample >= 0 && maps[i].is_uncovered[sample]) {
            found.shares[index] += 1 / float(maps[i].num_voxels[sample]);
          }
        }
      });
  return found;
}

}  // namespace octacut
