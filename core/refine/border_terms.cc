#include "core/refine/border_terms.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/refine/border_shift.h"
#include "core/refine/rim_targets.h"

namespace octacut {
namespace {

// Coarser pixels are too large to tell where a border is.
constexpr double kMaxBorderScale = 2;
// Nor can limbs as thin as patches: of the surface, pixels of the round.
constexpr double kMinBorderRadius = 6;
// Of the rims from their median, pixels: those that agree better tell a shift
// that much better than to the border's noise.
constexpr double kUsualDeviation = 0.15;
// Where there is nothing else: by how much their offsets are measured too far
// inside, pixels of the round times pixels of radius, and what that leaves
// open, in units of the noise (docs/refinement.md).
constexpr double kLimbBias = 1.5;
constexpr double kLimbNoise = 2;
// By how much vertices may leave a mask, pixels: the border of a mask of whole
// pixels is known to 0.29 of one, and where masks contradict one another to
// twice the usual distance of contours from borders, which is 1.3 standard
// deviations.
constexpr double kLeastTolerance = 0.25;
constexpr double kToleratedDistance = 2;

// Pixels to which what the rims say can be known: no better than they agree
// with one another.
double NoiseOf(const BorderExcess& excess, double border_noise) {
  const double share = std::min(1.0, excess.deviation / kUsualDeviation);
  return std::max(share * border_noise, excess.deviation);
}

// Of the masks' borders, pixels, in all: the plan's and what the rims tell of
// the rest.
double FindBorderShift(const std::vector<RimTarget>& rims,
                       const std::vector<LocalSurface>& surfaces,
                       const std::vector<OffsetMeasurement>& measurements,
                       const RoundPlan& plan,
                       double border_noise) {
  if (plan.scale > kMaxBorderScale) {
    return plan.border_shift;
  }
  if (const std::optional<BorderExcess> excess = MedianExcess(
          rims, surfaces, measurements, kMinBorderRadius * plan.scale, 0)) {
    return plan.edge_shift +
           ShrinkShift(plan.border_shift + excess->median - plan.edge_shift,
                       NoiseOf(*excess, border_noise));
  }
  // Only limbs are there to tell.
  if (const std::optional<BorderExcess> excess = MedianExcess(
          rims, surfaces, measurements, 0, kLimbBias * plan.scale)) {
    return plan.edge_shift +
           ShrinkShift(plan.border_shift + excess->median - plan.edge_shift,
                       kLimbNoise * std::max(border_noise, excess->deviation));
  }
  return plan.border_shift;
}

// Beside what the masks are too small by. In coarse rounds contours are only
// known to coarse pixels, so that distances mean the less.
double HullTolerance(const std::vector<RimTarget>& rims, double scale) {
  const std::optional<double> distance = MedianDistance(rims);
  return distance ? std::clamp(kToleratedDistance / scale * *distance,
                               kLeastTolerance,
                               kLargestHullTolerance)
                  : kLargestHullTolerance;
}

}  // namespace

void AddBorderTerms(const ViewSet& views,
                    const SeenSurface& seen,
                    const std::vector<OffsetMeasurement>& measurements,
                    double pixel,
                    const RoundPlan& plan,
                    const RefineOptions& options,
                    const Context& context,
                    OffsetProblem* problem,
                    RoundSummary* summary) {
  const std::vector<RimTarget> rims = FindRimTargets(views,
                                                     seen.rays,
                                                     seen.surfaces,
                                                     seen.places.neighbors,
                                                     summary->range,
                                                     plan.border_shift,
                                                     context);
  summary->num_rim_targets = rims.size();
  summary->hull_tolerance = HullTolerance(rims, plan.scale);
  if (summary->KnowsMost()) {
    summary->border_shift = FindBorderShift(
        rims, seen.surfaces, measurements, plan, options.border_noise);
  }
  for (const RimTarget& rim : rims) {
    EdgeTarget& target = problem->edge_targets.emplace_back(rim.edge);
    target.target = float(target.target / pixel);
    target.weight = float(options.silhouette_weight);
  }
}

}  // namespace octacut
