#include "core/evidence/depth_evidence.h"

#include <algorithm>
#include <optional>

#include "core/evidence/confirmed_depths.h"
#include "core/grid/parallel_voxels.h"

namespace octacut {
namespace {

// In voxels: how far before a surface space is surely free; the zone
// behind it that is surely matter.
constexpr float kFreeBefore = 1.5f;
constexpr float kMatterFrom = 1.0f;
constexpr float kMatterTo = 3.5f;
// At most so many views count for matter, and twice as many for free space:
// otherwise many views of one side would drown the others.
constexpr float kMaxVotes = 4;
// What the first view that sees through a voxel lacks of a vote: on its own
// its depth may be wrong and would drill a tunnel.
constexpr float kSingleView = 0.5f;
// Evidence, in words of views for matter, beyond which a voxel is solid.
constexpr double kSolidViews = 0.8;

// Depths that are wrong lie behind the surface, nearly all of them: what a
// doubtful depth says of matter is right or does no harm, what it says of free
// space and of surfaces counts as far as it can be relied upon.
float EvidenceAt(const ViewSet& views,
                 const ReliableDepths& depths,
                 const Eigen::Vector3f& point,
                 float voxel,
                 const InsideEvidenceOptions& options) {
  float matter = 0;
  float free_space = 0;
  float near_surface = 0;
  for (size_t i = 0; i < views.size(); ++i) {
    const std::optional<ProjectedPoint> p = views[i].projection.Project(point);
    if (!p) {
      continue;
    }
    const SweptDepthMap& map = depths.maps[i];
    const float depth = map.DepthAt(p->u, p->v);
    if (depth == 0) {
      continue;
    }
    const float confidence = map.ValueAt(depths.confidence[i], p->u, p->v);
    const float behind = (p->depth - depth) / voxel;
    if (behind < -kFreeBefore) {
      free_space += confidence;
    } else if (behind > kMatterFrom && behind < kMatterTo) {
      matter += 1;
    } else if (behind <= kMatterFrom) {
      near_surface = std::max(near_surface, confidence);
    }
  }
  // Beside a surface that some view has found, photo-consistency decides.
  return (1 - near_surface) * float(options.ballooning) +
         float(options.matter_weight) * std::min(matter, kMaxVotes) -
         float(options.free_space_weight) *
             std::clamp(free_space - kSingleView, 0.0f, 2 * kMaxVotes);
}

// The plausible ones of the depths of `paired`, where `values` is the evidence
// of better confirmed ones.
std::vector<SweptDepthMap> FindPlausible(
    const ViewSet& views,
    const VoxelGrid& voxels,
    const std::vector<SweptDepthMap>& paired,
    const std::vector<float>& values,
    const InsideEvidenceOptions& options,
    const Context& context) {
  const float least =
      float(options.ballooning + kSolidViews * options.matter_weight);
  std::vector<bool> solid(values.size());
  std::transform(values.begin(), values.end(), solid.begin(), [&](float value) {
    return value > least;
  });
  return KeepPlausible(
      views, voxels, paired, solid, options.min_like_samples, context);
}

// Adds to `maps` those depths of `others` that they lack.
void AddMissing(const std::vector<SweptDepthMap>& others,
                std::vector<SweptDepthMap>* maps) {
  for (size_t i = 0; i < maps->size(); ++i) {
    std::vector<float>& depths = (*maps)[i].depths;
    for (size_t k = 0; k < depths.size(); ++k) {
      depths[k] = depths[k] > 0 ? depths[k] : others[i].depths[k];
    }
  }
}

}  // namespace

size_t CountDepths(const std::vector<SweptDepthMap>& maps) {
  size_t count = 0;
  for (const SweptDepthMap& map : maps) {
    count += map.depths.size() -
             size_t(std::count(map.depths.begin(), map.depths.end(), 0.0f));
  }
  return count;
}

std::vector<float> EvidenceOf(const ViewSet& views,
                              const VoxelGrid& voxels,
                              const ReliableDepths& depths,
                              const InsideEvidenceOptions& options,
                              const Context& context) {
  std::vector<float> values(voxels.Size());
  ParallelForVoxels(
      context, voxels, [&](VoxelGrid::Index index, MortonCode code) {
        values[index] =
            EvidenceAt(views,
                       depths,
                       VoxelCenter(DecodeMorton(code), voxels.Level()),
                       1.0f / float(voxels.Resolution()),
                       options);
      });
  return values;
}

void AddMatterInPits(const ViewSet& views,
                     const VoxelGrid& voxels,
                     const SurfaceVerdict& surface,
                     const InsideEvidenceOptions& options,
                     const Context& context,
                     std::vector<float>* values) {
  if (std::none_of(surface.in_pit.begin(),
                   surface.in_pit.end(),
                   [](const std::vector<uint8_t>& of_view) {
                     return std::count(of_view.begin(), of_view.end(), 1) > 0;
                   })) {
    return;  // as in most scenes
  }
  const float voxel = 1.0f / float(voxels.Resolution());
  ParallelForVoxels(
      context, voxels, [&](VoxelGrid::Index index, MortonCode code) {
        const Eigen::Vector3f center =
            VoxelCenter(DecodeMorton(code), voxels.Level());
        float matter = 0;
        for (size_t i = 0; i < views.size(); ++i) {
          const auto p = views[i].projection.Project(center);
          if (!p) {
            continue;
          }
          const SweptDepthMap& map = surface.depths.maps[i];
          const std::optional<size_t> sample = map.SampleAt(p->u, p->v);
          if (sample && surface.in_pit[i][*sample] &&
              p->depth < map.depths[*sample] + kMatterFrom * voxel) {
            matter += 1;
          }
        }
        (*values)[index] +=
            float(options.matter_weight) * std::min(matter, kMaxVotes);
      });
}

std::vector<float> EvidenceWithPlausible(
    const ViewSet& views,
    const VoxelGrid& voxels,
    const std::vector<SweptDepthMap>& paired,
    const InsideEvidenceOptions& options,
    const Context& context,
    ReliableDepths* depths) {
  std::vector<float> values =
      EvidenceOf(views, voxels, *depths, options, context);
  if (options.min_agreeing_views == 1 || options.min_like_samples > 8) {
    return values;
  }
  AddMissing(FindPlausible(views, voxels, paired, values, options, context),
             &depths->maps);
  return EvidenceOf(views, voxels, *depths, options, context);
}

}  // namespace octacut
