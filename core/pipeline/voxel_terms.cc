#include "core/pipeline/voxel_terms.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/stopwatch.h"
#include "core/grid/morphology.h"
#include "core/grid/parallel_voxels.h"
#include "core/visibility/surface_normals.h"

namespace octacut {
namespace {

// A weight of l0, halved with every level: evidence grows with the volume of a
// voxel, edges with its side.
float AtLevel(double weight, int level, const ReconstructionOptions& options) {
  return float(std::ldexp(weight, options.hull.hull_level - level));
}

enum class Outsideness { kNo, kNearObject, kSure };

// Whether a cube is background in a view, or would not be if the mask's object
// were larger by the tolerance.
Outsideness Outside(const PreparedView& view,
                    const Eigen::Vector3f& center,
                    float half_edge) {
  if (!view.silhouette.IsBackgroundCube(view.projection, center, half_edge)) {
    return Outsideness::kNo;
  }
  return view.silhouette.IsBackgroundCube(
             view.projection, center, half_edge, view.mask_tolerance)
             ? Outsideness::kSure
             : Outsideness::kNearObject;
}

}  // namespace

void ExtendTerms(const ViewSet& views,
                 const std::vector<float>& mask_trust,
                 const Visibility& visibility,
                 const Crust& crust,
                 const ReconstructionOptions& options,
                 const Context& context,
                 VoxelTerms* terms,
                 LevelSummary* summary) {
  Stopwatch stopwatch;
  VoxelTerms extended{crust.voxels,
                      std::vector<float>(crust.voxels.Size()),
                      std::vector<float>(crust.voxels.Size())};
  std::vector<uint8_t> is_new(crust.voxels.Size());
  bool all_new = true;
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const VoxelGrid::Index before = terms->voxels.Find(code);
    is_new[index] = before == VoxelGrid::kNone;
    if (!is_new[index]) {
      all_new = false;
      extended.phi[index] = terms->phi[before];
      extended.evidence[index] = terms->evidence[before];
    }
  });
  summary->crust_seconds += stopwatch.Lap();
  const std::vector<Eigen::Vector3f> normals =
      EstimateNormals(crust.voxels,
                      crust.ties,
                      crust.prior,
                      options.normal_blur,
                      context,
                      all_new ? std::span<const uint8_t>() : is_new);
  summary->visibility_seconds += stopwatch.Lap();
  const VoxelGrid added = Subset(crust.voxels, is_new);
  const PhotoConsistency consistency = EstimateConsistency(
      views, added, normals, visibility, options.consistency, context);
  summary->consistency_seconds += stopwatch.Lap();
  summary->consistency.Add(consistency.summary);
  const std::vector<float> silhouette =
      SilhouetteEvidence(views, mask_trust, added, options, context);
  const float unseen =
      AtLevel(options.energy.unseen_weight, crust.voxels.Level(), options);
  size_t next = 0;
  for (size_t i = 0; i < is_new.size(); ++i) {
    if (is_new[i]) {
      extended.phi[i] = consistency.phi[next];
      extended.evidence[i] = silhouette[next] < 0        ? silhouette[next]
                             : consistency.is_seen[next] ? 0.0f
                                                         : unseen;
      ++next;
    }
  }
  *terms = std::move(extended);
  summary->crust_seconds += stopwatch.Lap();
}

std::vector<float> EdgeWeights(const std::vector<float>& phi,
                               const EnergyOptions& options) {
  std::vector<float> weights(phi.size());
  for (size_t i = 0; i < phi.size(); ++i) {
    weights[i] = float(std::pow(double(phi[i]), options.smoothness) +
                       options.area_weight);  // HK06 eq. (3)
  }
  return weights;
}

std::vector<float> SilhouetteEvidence(const ViewSet& views,
                                      const std::vector<float>& mask_trust,
                                      const VoxelGrid& voxels,
                                      const ReconstructionOptions& options,
                                      const Context& context) {
  std::vector<float> evidence(voxels.Size());
  const float half_edge = 0.5f / float(voxels.Resolution());
  const float near_weight =
      AtLevel(options.energy.mask_border_weight, voxels.Level(), options);
  ParallelForVoxels(
      context, voxels, [&](VoxelGrid::Index index, MortonCode code) {
        const Eigen::Vector3f center =
            VoxelCenter(DecodeMorton(code), voxels.Level());
        for (size_t i = 0; i < views.size(); ++i) {
          switch (Outside(views[i], center, half_edge)) {
            case Outsideness::kNo:
              break;
            case Outsideness::kNearObject:
              evidence[index] =
                  std::min(evidence[index], -near_weight * mask_trust[i]);
              break;
            case Outsideness::kSure:
              evidence[index] = -float(options.energy.silhouette_weight);
              return;
          }
        }
      });
  return evidence;
}

}  // namespace octacut
