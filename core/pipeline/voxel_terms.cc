#include "core/pipeline/voxel_terms.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/evidence/mask_confidence.h"
#include "core/grid/morphology.h"

namespace octacut {
namespace {

// A weight of l0, halved with every level: evidence grows with the volume of a
// voxel, edges with its side.
float AtLevel(double weight, int level, const ReconstructionOptions& options) {
  return float(std::ldexp(weight, options.hull.hull_level - level));
}

constexpr size_t kBrickGrain = 64;
// Half the diagonal of a voxel, in voxels: if its centre is that far outside,
// all of it is.
constexpr float kHalfDiagonal = 0.87f;

}  // namespace

AddedVoxels FindAddedVoxels(const Crust& crust, const VoxelTerms& terms) {
  AddedVoxels added;
  added.is_added.resize(crust.voxels.Size());
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    added.is_added[index] = terms.voxels.Find(code) == VoxelGrid::kNone;
  });
  added.voxels = Subset(crust.voxels, added.is_added);
  return added;
}

float UnseenEvidence(int level, const ReconstructionOptions& options) {
  return AtLevel(EnergyOptions::kUnseenWeight, level, options);
}

VoxelTerms MergeTerms(const VoxelGrid& crust,
                      const VoxelTerms& terms,
                      const AddedVoxels& added,
                      const PhotoConsistency& consistency,
                      const SilhouetteTerms& silhouettes,
                      float unseen_evidence) {
  VoxelTerms merged{crust,
                    std::vector<float>(crust.Size()),
                    std::vector<float>(crust.Size()),
                    std::vector<float>(crust.Size())};
  size_t next = 0;
  crust.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    if (added.is_added[index]) {
      const float outside = silhouettes.evidence[next];
      merged.phi[index] = consistency.phi[next];
      merged.evidence[index] = outside < 0                 ? outside
                               : consistency.is_seen[next] ? 0.0f
                                                           : unseen_evidence;
      merged.hull_depth[index] = silhouettes.hull_depth[next];
      ++next;
    } else {
      const VoxelGrid::Index before = terms.voxels.Find(code);
      merged.phi[index] = terms.phi[before];
      merged.evidence[index] = terms.evidence[before];
      merged.hull_depth[index] = terms.hull_depth[before];
    }
  });
  return merged;
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

float NeutralWeight(const ReconstructionOptions& options) {
  return EdgeWeights({float(options.consistency.neutral)}, options.energy)[0];
}

namespace {

// The views that bound a brick's voxels, found once for all of them: where the
// object reaches far beyond the brick in a view, others decide.
class BoundingViews {
 public:
  BoundingViews(const ViewSet& views,
                const std::vector<float>& mask_confidence,
                int level)
      : views_(views),
        mask_confidence_(mask_confidence),
        voxel_(1.0f / float(1 << level)) {}

  const std::vector<uint32_t>& Of(uint64_t brick) {
    if (!has_brick_ || brick != brick_) {
      Find(brick);
    }
    return chosen_;
  }

 private:
  void Find(uint64_t brick) {
    has_brick_ = true;
    brick_ = brick;
    const Eigen::Vector3f center =
        4 * voxel_ *
        (DecodeMorton(brick).cast<float>() + Eigen::Vector3f::Constant(0.5f));
    least_.assign(views_.size(), -Silhouette::kFarInside);
    float bound = Silhouette::kFarInside;
    for (size_t i = 0; i < views_.size(); ++i) {
      const ViewProjection& projection = views_[i].projection;
      const std::optional<ProjectedPoint> p =
          projection.ProjectIntoFrame(center);
      if (!p || !views_[i].silhouette.KnowsAll(p->u, p->v, p->u, p->v)) {
        continue;  // the view may know some of its voxels
      }
      const float footprint = projection.Footprint(voxel_, p->depth);
      const float depth = views_[i].DistanceInside(*p) / footprint;
      // Distances are in pixels and may jump by one at a border; depths
      // across the brick change by less than the share that is added.
      const float reach = kBrickReach + kBorderStep / footprint +
                          kDepthChange * std::abs(depth);
      least_[i] = depth - reach;
      const float margin = reach * footprint;
      if (mask_confidence_[i] > kReliableMask &&
          views_[i].silhouette.KnowsAll(
              p->u - margin, p->v - margin, p->u + margin, p->v + margin)) {
        bound = std::min(bound, depth + reach);
      }
    }
    // Those that show the brick's voxels outside or beside the border count,
    // too, as evidence.
    bound = std::max(bound, 1.0f);
    chosen_.clear();
    for (uint32_t i = 0; i < views_.size(); ++i) {
      if (least_[i] <= bound) {
        chosen_.push_back(i);
      }
    }
  }

  // Voxels: from the middle of a brick to the centres of its voxels, and as
  // much again for views that see it far from their axes.
  static constexpr float kBrickReach = 5.2f;
  static constexpr float kBorderStep = 2;  // pixels
  static constexpr float kDepthChange = 0.1f;

  const ViewSet& views_;
  const std::vector<float>& mask_confidence_;
  float voxel_;
  bool has_brick_ = false;
  uint64_t brick_ = 0;
  std::vector<float> least_;
  std::vector<uint32_t> chosen_;
};

}  // namespace

SilhouetteTerms EstimateSilhouetteTerms(
    const ViewSet& views,
    const std::vector<float>& mask_confidence,
    const VoxelGrid& voxels,
    const ReconstructionOptions& options,
    const Context& context) {
  const double near_weight = voxels.Level() == options.hull.hull_level
                                 ? options.energy.mask_border_weight
                                 : 0;
  SilhouetteTerms terms{std::vector<float>(voxels.Size()),
                        std::vector<float>(voxels.Size())};
  const float voxel = 1.0f / float(voxels.Resolution());
  ParallelFor(
      context,
      voxels.Bricks().size(),
      kBrickGrain,
      [&](size_t begin, size_t end) {
        BoundingViews bounding(views, mask_confidence, voxels.Level());
        voxels.ForEachInBricks(
            begin, end, [&](VoxelGrid::Index index, MortonCode code) {
              const Eigen::Vector3f center =
                  VoxelCenter(DecodeMorton(code), voxels.Level());
              float least_depth = Silhouette::kFarInside;
              float evidence = 0;
              for (const uint32_t i : bounding.Of(code >> 6)) {
                const ViewProjection& projection = views[i].projection;
                const std::optional<ProjectedPoint> p =
                    projection.ProjectIntoFrame(center);
                if (!p) {
                  continue;
                }
                const float pixels =
                    views[i].silhouette.SignedDistance(p->u, p->v);
                const float footprint = projection.Footprint(voxel, p->depth);
                const float depth =
                    (pixels - views[i].border_shift) / footprint;
                const float tolerance =
                    std::max(views[i].mask_tolerance, -views[i].border_shift);
                const bool is_sure =
                    pixels <= -(tolerance + kHalfDiagonal * footprint);
                if (is_sure || mask_confidence[i] > kReliableMask) {
                  least_depth = std::min(least_depth, depth);
                }
                const double weight = is_sure
                                          ? options.energy.silhouette_weight
                                          : near_weight * mask_confidence[i];
                evidence = std::min(
                    evidence,
                    -float(weight) * std::clamp(-2 * depth, 0.0f, 1.0f));
              }
              terms.evidence[index] = evidence;
              terms.hull_depth[index] = least_depth;
            });
      });
  return terms;
}

}  // namespace octacut
