#include "core/refine/border_terms.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/refine/border_shift.h"

namespace octacut {
namespace {

// Coarser pixels are too large to tell where a border is.
constexpr double kMaxBorderScale = 2;
// Neither can structures as thin as patches. Radius of the surface, pixels of
// the round.
constexpr double kMinBorderRadius = 6;
// Pixels to which occluding contours tell how far the borders are shifted as a
// whole: much smaller shifts are taken for noise
// (docs/experiments/refinement_silhouettes.md).
constexpr double kBorderNoise = 0.3;
// The usual deviation of the occluding contours from their median, pixels:
// contours that agree better determine a shift that much better than to the
// border's noise.
constexpr double kUsualDeviation = 0.15;
// Where there is nothing else: how well they tell, in units of the noise
// (docs/experiments/refinement_silhouettes.md).
constexpr double kThinStructureNoise = 2;
// Pixels by which vertices may leave a mask at least: about what is known of
// the border of a mask of whole pixels.
constexpr double kLeastTolerance = 0.25;
// The same where masks contradict one another, in median distances of contours
// from borders: 1.3 standard deviations.
constexpr double kToleratedDistance = 2;
// Where most points have no offset, the surface between occluding contours
// follows them alone, and stiffly: twice the weight lets it bend
// (docs/experiments/refinement_silhouettes.md).
constexpr double kMaxContourWeight = 2;
// A hundredth of what is normally distributed lies farther out on one side than
// so many median distances.
constexpr double kNormalTail = 3.45;

// Pixels to which what the occluding contours say can be known: no better than
// they agree with one another.
double NoiseOf(const BorderExcess& excess) {
  const double share = std::min(1.0, excess.deviation / kUsualDeviation);
  return std::max(share * kBorderNoise, excess.deviation);
}

// Whether the borders are where the photographs put the outlines as a whole,
// and more of them lie farther inside than by noise.
bool HasBites(const BorderExcess& excess) {
  return std::abs(excess.median) < excess.deviation &&
         excess.bites > kNormalTail * excess.deviation;
}

// What the occluding contours say of the masks' borders.
struct BorderFindings {
  double shift = 0;  // pixels, in all
  double bites = 0;  // BorderExcess; 0 where there are none
};

// The shift is the plan's, and what is left of it.
BorderFindings FindBorders(const std::vector<ContourTarget>& contours,
                           const std::vector<LocalSurface>& surfaces,
                           const std::vector<OffsetMeasurement>& measurements,
                           const RoundPlan& plan) {
  if (plan.scale > kMaxBorderScale) {
    return {.shift = plan.border_shift};
  }
  const auto shift = [&](double median, double noise) {
    return plan.edge_shift +
           ShrinkShift(plan.border_shift + median - plan.edge_shift, noise);
  };
  if (const std::optional<BorderExcess> excess = MeasureExcess(
          contours, surfaces, measurements, kMinBorderRadius * plan.scale)) {
    return {.shift = shift(excess->median, NoiseOf(*excess)),
            .bites = HasBites(*excess) ? excess->bites : 0};
  }
  // Only thin structures are there to tell.
  if (const std::optional<BorderExcess> excess =
          MeasureExcess(contours, surfaces, measurements, 0)) {
    return {.shift = shift(excess->median,
                           kThinStructureNoise *
                               std::max(kBorderNoise, excess->deviation))};
  }
  return {.shift = plan.border_shift};
}

// In addition to the pixels by which masks are too small. In coarse rounds
// contours are only known to coarse pixels, so that distances mean the less.
double HullTolerance(const std::vector<ContourTarget>& contours, double scale) {
  const std::optional<double> distance = MedianDistance(contours);
  return distance ? std::clamp(kToleratedDistance / scale * *distance,
                               kLeastTolerance,
                               kLargestHullTolerance)
                  : kLargestHullTolerance;
}

}  // namespace

BorderVerdict JudgeBorders(const std::vector<ContourTarget>& contours,
                           const std::vector<LocalSurface>& surfaces,
                           const std::vector<OffsetMeasurement>& measurements,
                           const RoundPlan& plan,
                           bool knows_most) {
  const double tolerance = HullTolerance(contours, plan.scale);
  if (!knows_most) {
    return {
        .shift = plan.border_shift,
        .hull_tolerance = tolerance,
        .contour_weight = std::clamp(1 / tolerance, 1.0, kMaxContourWeight)};
  }
  // Offsets on dark and ruffled surfaces lie too far inside, and claim shifts
  // that the edges contradict (docs/experiments/mask_borders.md).
  const BorderFindings borders =
      FindBorders(contours, surfaces, measurements, plan);
  return {.shift = std::clamp(borders.shift,
                              plan.edge_shift - plan.edge_shift_slack,
                              plan.edge_shift + plan.edge_shift_slack),
          .hull_tolerance =
              std::clamp(borders.bites, tolerance, kLargestHullTolerance)};
}

void AddContourTargets(const std::vector<ContourTarget>& contours,
                       double pixel,
                       double weight,
                       OffsetProblem* problem) {
  for (const ContourTarget& contour : contours) {
    EdgeTarget& target = problem->edge_targets.emplace_back(contour.edge);
    target.target = float(target.target / pixel);
    target.weight = float(weight);
  }
}

}  // namespace octacut
