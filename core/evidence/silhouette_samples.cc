#include "core/evidence/silhouette_samples.h"

#include <algorithm>
#include <optional>

#include "core/base/parallel.h"
#include "core/grid/count_bits.h"
#include "core/grid/morphology.h"

namespace octacut {
namespace {

// Half the side of a voxel's footprint around its centre, in voxels, that
// covers the middles of samples: more than half the diagonal of a face, so that
// no ray slips between voxels of matter.
constexpr float kReach = 0.75f;
// Faces from which on the surface passes the middle of a voxel or beyond.
constexpr int kHalfInside = kNumFaces / 2;

VoxelGrid MatterOf(const VoxelGrid& voxels,
                   const std::vector<FaceLabels>& labels) {
  std::vector<uint8_t> is_matter(labels.size());
  for (size_t i = 0; i < labels.size(); ++i) {
    is_matter[i] = CountBits(labels[i]) >= kHalfInside;
  }
  return Subset(voxels, is_matter);
}

// Of a number that is not negative; faster than std::ceil where the processor
// may be any that runs Debian.
int RoundUp(float x) {
  const int down = int(x);
  return down + (float(down) < x ? 1 : 0);
}

void MarkCovered(const ViewProjection& projection,
                 const Eigen::Vector3f& center,
                 float voxel,
                 SampleMap* map) {
  const std::optional<ProjectedPoint> p = projection.Project(center);
  if (!p) {
    return;
  }
  const float reach =
      kReach *
      std::max(1.0f, projection.Footprint(voxel, p->depth) * map->scale);
  // From the middle of the first sample.
  const float x = p->u * map->scale - 0.5f;
  const float y = p->v * map->scale - 0.5f;
  // Written so that points far out of the frame need no integer.
  if (!(x > -reach && y > -reach && x < float(map->width) + reach &&
        y < float(map->height) + reach)) {
    return;
  }
  const int x0 = RoundUp(std::max(0.0f, x - reach));
  const int y0 = RoundUp(std::max(0.0f, y - reach));
  const int x1 = std::min(map->width - 1, int(x + reach));
  const int y1 = std::min(map->height - 1, int(y + reach));
  for (int row = y0; row <= y1; ++row) {
    for (int column = x0; column <= x1; ++column) {
      map->is_covered[size_t(row) * map->width + column] = 1;
    }
  }
}

bool IsSure(const PreparedView& view, const SampleMap& map, int x, int y) {
  const float u = (float(x) + 0.5f) / map.scale;
  const float v = (float(y) + 0.5f) / map.scale;
  return view.silhouette.IsKnown(u, v) &&
         view.silhouette.SignedDistance(u, v) >
             std::max(view.SureDepth(), 1 / map.scale);
}

SampleMap MapView(const PreparedView& view, const VoxelGrid& matter) {
  const ViewProjection& projection = view.projection;
  const float voxel = 1.0f / float(matter.Resolution());
  SampleMap map;
  map.scale = std::min(1.0f, 1 / projection.CenterFootprint(voxel));
  map.width = std::max(1, int(float(projection.width) * map.scale));
  map.height = std::max(1, int(float(projection.height) * map.scale));
  map.is_sure.resize(size_t(map.width) * map.height);
  map.is_covered.resize(map.is_sure.size());
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      map.is_sure[size_t(y) * map.width + x] = IsSure(view, map, x, y);
    }
  }
  matter.ForEach([&](VoxelGrid::Index, MortonCode code) {
    MarkCovered(projection,
                VoxelCenter(DecodeMorton(code), matter.Level()),
                voxel,
                &map);
  });
  return map;
}

}  // namespace

int SampleMap::At(const ViewProjection& projection,
                  const Eigen::Vector3f& point) const {
  const std::optional<ProjectedPoint> p = projection.ProjectIntoFrame(point);
  if (!p) {
    return -1;
  }
  const int x = std::min(int(p->u * scale), width - 1);
  const int y = std::min(int(p->v * scale), height - 1);
  return y * width + x;
}

std::vector<SampleMap> MapSamples(const ViewSet& views,
                                  const VoxelGrid& voxels,
                                  const std::vector<FaceLabels>& labels,
                                  const Context& context) {
  const VoxelGrid matter = MatterOf(voxels, labels);
  std::vector<SampleMap> maps(views.size());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    maps[i] = MapView(views[i], matter);
  });
  return maps;
}

SampleCounts CountSamples(const std::vector<SampleMap>& maps) {
  SampleCounts counts;
  for (const SampleMap& map : maps) {
    for (size_t s = 0; s < map.Size(); ++s) {
      counts.num_sure += map.is_sure[s];
      counts.num_uncovered += map.IsUncovered(s);
    }
  }
  return counts;
}

}  // namespace octacut
