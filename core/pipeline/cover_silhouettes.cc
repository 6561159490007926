#include "core/pipeline/cover_silhouettes.h"

#include <algorithm>
#include <cmath>

#include "core/cut/fixed_point.h"
#include "core/evidence/covering_voxels.h"
#include "core/evidence/silhouette_samples.h"
#include "core/pipeline/coarser_surface.h"

namespace octacut {
namespace {

// Share of the score that the depth in the hull has: it tells the middle of a
// part from its border where averaging has everything inside.
constexpr float kDepthShare = 0.2f;
// Depth, voxels, from which on there is no more to tell.
constexpr float kDeep = 20;

CoverCandidates FindCandidates(const Crust& crust,
                               const CoverPreference& preference,
                               const Context& context) {
  CoverCandidates candidates;
  if (preference.evidence.empty()) {
    candidates.scores = CoarserInside(crust, context);
    candidates.is_likely.resize(candidates.scores.size());
    for (size_t i = 0; i < candidates.scores.size(); ++i) {
      candidates.is_likely[i] = candidates.scores[i] >= 0.5f;
    }
  } else {
    for (const float e : preference.evidence) {
      candidates.scores.push_back(0.5f + 0.5f * e / (1 + std::abs(e)));
    }
  }
  for (size_t i = 0; i < candidates.scores.size(); ++i) {
    const float depth = preference.hull_depth[i];
    const bool is_outside = (crust.ties[i] & kAllOutside) != 0;
    float& score = candidates.scores[i];
    score = depth < 0 || is_outside
                ? -1
                : (1 - kDepthShare) * score +
                      kDepthShare * std::min(depth / kDeep, 1.0f);
  }
  return candidates;
}

}  // namespace

CoverDemand DemandCover(const ViewSet& views,
                        const Crust& crust,
                        const std::vector<FaceLabels>& labels,
                        const CoverPreference& preference,
                        const Context& context,
                        std::vector<float>* evidence) {
  const std::vector<SampleMap> maps =
      MapSamples(views, crust.voxels, labels, context);
  const SampleCounts counts = CountSamples(maps);
  CoverDemand demand;
  if (counts.num_uncovered == 0) {
    return demand;
  }
  const CoveringVoxels covering =
      FindCoveringVoxels(views,
                         crust.voxels,
                         labels,
                         maps,
                         FindCandidates(crust, preference, context),
                         context);
  for (size_t i = 0; i < evidence->size(); ++i) {
    if (covering.is_covering[i]) {
      (*evidence)[i] = kMaxEvidence;
    }
  }
  demand.uncovered = double(counts.num_uncovered) / double(counts.num_sure);
  demand.impossible = double(covering.num_impossible) / double(counts.num_sure);
  demand.num_voxels = covering.num_voxels;
  return demand;
}

}  // namespace octacut
