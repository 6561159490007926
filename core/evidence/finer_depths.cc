#include "core/evidence/finer_depths.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/evidence/confirmed_depths.h"
#include "core/evidence/depth_confidence.h"
#include "core/evidence/depth_evidence.h"
#include "core/evidence/neighbor_views.h"
#include "core/evidence/surface_sweep.h"
#include "core/grid/morphology.h"

namespace octacut {
namespace {

// A sweep pays where more than this share of the confirmed depths leads beyond
// the surface's crust: some depths in ten thousand are wrong though confirmed.
constexpr double kPays = 5e-4;
// Voxels that such a depth lies farther than the crust: what is nearer is
// within the error of depths, and the crust grows there by itself.
constexpr int kClearlyBeyond = 2;
// Voxels from a depth to the crust in which its ray has met the surface: as far
// as the sweep reaches, aslant. Others lie beside an outline.
constexpr int kLongestWay = 25;
// Voxels behind a depth, and beside the way to it, that a crust needs.
constexpr int kReachBehind = 4;
constexpr int kReachBeside = 2;

// The ray of a depth through the voxels of a crust and behind it.
class DepthRay {
 public:
  DepthRay(const VoxelGrid& crust,
           const Eigen::Vector3f& center,
           const Eigen::Vector3f& ray,
           float depth)
      : crust_(crust),
        point_((center + depth * ray) * float(crust.Resolution())),
        step_(ray.normalized()) {}

  // So many voxels behind the depth.
  Eigen::Vector3i VoxelAt(float behind) const {
    return (point_ + behind * step_).array().floor().cast<int>();
  }
  bool IsInCube(const Eigen::Vector3i& voxel) const {
    return (voxel.array() >= 0).all() &&
           (voxel.array() < crust_.Resolution()).all();
  }
  // Voxels from the crust to the depth, up to kLongestWay; 0 in the crust.
  int WayFromCrust() const {
    int way = 0;
    while (way < kLongestWay) {
      const Eigen::Vector3i voxel = VoxelAt(float(-way));
      if (!IsInCube(voxel)) {
        return kLongestWay;
      }
      if (crust_.Contains(voxel)) {
        break;
      }
      ++way;
    }
    return way;
  }

 private:
  const VoxelGrid& crust_;
  Eigen::Vector3f point_;
  Eigen::Vector3f step_;
};

// The voxels between a crust and the depths behind it, with what is around
// them. Counts the depths that are clearly beyond.
VoxelGrid VoxelsBeyond(const ViewSet& views,
                       const VoxelGrid& crust,
                       const std::vector<SweptDepthMap>& maps,
                       const Context& context,
                       size_t* num_beyond) {
  std::vector<std::vector<MortonCode>> codes(maps.size());
  std::vector<size_t> counts(maps.size());
  ParallelEach(context, maps.size(), 1, [&](size_t i) {
    const ViewProjection& projection = views[i].projection;
    ForEachDepth(maps[i],
                 projection,
                 [&](int, int, float depth, const Eigen::Vector3f& direction) {
                   const DepthRay ray(
                       crust, projection.center, direction, depth);
                   const int way = ray.WayFromCrust();
                   if (way == 0 || way == kLongestWay) {
                     return;
                   }
                   counts[i] += way > kClearlyBeyond;
                   for (int behind = 1 - way; behind < kReachBehind; ++behind) {
                     const Eigen::Vector3i voxel = ray.VoxelAt(float(behind));
                     if (ray.IsInCube(voxel)) {
                       codes[i].push_back(EncodeMorton(voxel));
                     }
                   }
                 });
    std::sort(codes[i].begin(), codes[i].end());
    codes[i].erase(std::unique(codes[i].begin(), codes[i].end()),
                   codes[i].end());
  });
  std::vector<MortonCode> all;
  *num_beyond = 0;
  for (size_t i = 0; i < codes.size(); ++i) {
    all.insert(all.end(), codes[i].begin(), codes[i].end());
    *num_beyond += counts[i];
  }
  return Dilate(VoxelGrid::FromCodes(crust.Level(), std::move(all)),
                kReachBeside,
                context);
}

// Confidence in a depth is no more than the first sweep has in those around it.
void LimitConfidence(const ViewSet& views,
                     const VoxelValues& depth_confidence,
                     const Context& context,
                     ReliableDepths* depths) {
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    const SweptDepthMap& map = depths->maps[i];
    const Eigen::Vector3f& center = views[i].projection.center;
    ForEachDepth(
        map,
        views[i].projection,
        [&](int x, int y, float depth, const Eigen::Vector3f& ray) {
          float& confidence = depths->confidence[i][size_t(y) * map.width + x];
          confidence = std::min(
              confidence, depth_confidence.AtPoint(center + depth * ray, 1));
        });
  });
}

struct FinerMaps {
  std::vector<SweptDepthMap> swept;
  std::vector<std::vector<uint8_t>> counts;  // of confirming neighbours
  std::vector<SweptDepthMap> agreeing;
  VoxelGrid beyond;  // as VoxelsBeyond has them
};

// Empty where a sample of the surface says that it does not pay.
FinerMaps SweepNearSurface(const ViewSet& views,
                           const LabeledVoxels& surface,
                           const VoxelValues& depth_confidence,
                           const InsideEvidenceOptions& options,
                           const Context& context) {
  const DepthSweepOptions& sweep = options.sweep;
  const std::vector<std::vector<int>> neighbors = SelectNeighborViews(
      views, sweep.num_neighbors, sweep.min_angle, sweep.max_angle);
  Phase phase(context, "finer depth sweep", 3 * views.size());
  const VoxelGrid cut = VoxelsOfCut(surface);
  std::vector<SweepView> reduced(views.size());
  FinerMaps maps;
  maps.swept.resize(views.size());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    reduced[i] =
        ReduceForSweep(views[i], cut, DepthSweepOptions::kSamplesPerVoxel);
    phase.Advance();
  });
  const SurfaceSweep around(
      reduced, depth_confidence, surface.voxels.Level(), sweep);
  for (size_t i = 0; i < views.size(); ++i) {
    maps.swept[i] = around.EmptyMap(int(i));
  }
  for (const bool of_sample : {true, false}) {
    ParallelEach(context, views.size(), 1, [&](size_t i) {
      around.AddDepths(int(i), neighbors[i], of_sample, &maps.swept[i]);
      phase.Advance();
    });
    maps.counts = CountAgreeing(views,
                                maps.swept,
                                neighbors,
                                1.0f / float(surface.voxels.Resolution()),
                                context);
    maps.agreeing =
        KeepAgreeing(maps.swept, maps.counts, options.min_agreeing_views);
    size_t num_beyond = 0;
    maps.beyond = VoxelsBeyond(
        views, surface.voxels, maps.agreeing, context, &num_beyond);
    if (double(num_beyond) <= kPays * double(CountDepths(maps.agreeing))) {
      maps.beyond = VoxelGrid();
      return maps;
    }
  }
  return maps;
}

}  // namespace

FinerEvidence FindFinerDepths(const ViewSet& views,
                              const LabeledVoxels& surface,
                              const VoxelValues& depth_confidence,
                              const InsideEvidenceOptions& options,
                              const Context& context) {
  FinerMaps maps =
      SweepNearSurface(views, surface, depth_confidence, options, context);
  FinerEvidence finer;
  if (maps.beyond.Empty()) {
    return finer;
  }
  finer.voxels = Union(surface.voxels, maps.beyond);
  // Here only some squares are searched: few depths tell nothing.
  constexpr double kSurroundedShare = 0;
  constexpr float kShown = 1;  // depth_confidence has it
  ReliableDepths depths = EstimateDepthConfidence(
      views, finer.voxels, maps.agreeing, kSurroundedShare, kShown, context);
  LimitConfidence(views, depth_confidence, context, &depths);
  InsideEvidenceOptions without_ballooning = options;
  without_ballooning.ballooning = 0;
  finer.values =
      EvidenceWithPlausible(views,
                            finer.voxels,
                            KeepAgreeing(std::move(maps.swept), maps.counts, 1),
                            without_ballooning,
                            context,
                            &depths);
  return finer;
}

}  // namespace octacut
