#include "core/refine/refine_round.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/refine/align_views.h"
#include "core/refine/border_shift.h"
#include "core/refine/keep_valid.h"
#include "core/refine/move_vertices.h"
#include "core/refine/offset_search.h"
#include "core/refine/offset_support.h"
#include "core/refine/place_planes.h"
#include "core/refine/rim_targets.h"
#include "core/refine/seen_surface.h"
#include "core/refine/solve_offsets.h"

namespace octacut {
namespace {

// Rings of unseen places around seen ones that may move along with them.
constexpr int kBlendRings = 2;
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
// By how much offsets a few patches apart may differ and still mean the same
// surface, pixels of the round.
constexpr double kSupportTolerance = 1;
// How far a place speaks of vertices, in distances between places.
constexpr double kReach = 1.3;

// Mean distance between neighbouring places.
double MeanSpacing(const IndexedMesh& mesh, const SurfacePlaces& places) {
  double sum = 0;
  for (size_t i = 0; i < places.vertices.size(); ++i) {
    for (const uint32_t next : places.neighbors.Of(i)) {
      sum += (mesh.positions[places.vertices[i]] -
              mesh.positions[places.vertices[next]])
                 .norm();
    }
  }
  return sum / double(std::max<size_t>(places.neighbors.corners.size(), 1));
}

void Align(const SeenSurface& seen,
           const RefineOptions& options,
           const Context& context,
           ViewSet* views,
           RoundSummary* summary) {
  const Phase phase(context, "refinement: pose alignment");
  for (int i = 0; i < options.alignment_steps; ++i) {
    summary->num_aligned =
        AlignViews(seen.surfaces, seen.choices, options.patch, context, views);
  }
}

OffsetSearch MakeSearch(const RoundPlan& plan, const RefineOptions& options) {
  OffsetSearch search;
  search.range = plan.range * plan.scale;
  search.step = options.step * plan.scale;
  search.spacing = plan.scale;
  search.min_score = options.min_score;
  search.patch = options.patch;
  return search;
}

std::vector<OffsetMeasurement> MeasureOffsets(const ViewSet& views,
                                              const SeenSurface& seen,
                                              const RoundPlan& plan,
                                              const RefineOptions& options,
                                              std::string_view phase_name,
                                              const Context& context) {
  Phase phase(context, phase_name, seen.surfaces.size());
  return SearchOffsets(views,
                       seen.surfaces,
                       seen.choices,
                       MakeSearch(plan, options),
                       context,
                       &phase);
}

// Lengths in pixels.
OffsetProblem MakeProblem(const SeenSurface& seen,
                          const std::vector<OffsetMeasurement>& measurements,
                          double pixel,
                          double scale,
                          RoundSummary* summary) {
  OffsetProblem problem;
  for (size_t i = 0; i < measurements.size(); ++i) {
    const OffsetMeasurement& measurement = measurements[i];
    problem.normals.push_back(seen.surfaces[i].normal);
    problem.targets.push_back(float(measurement.offset / pixel));
    problem.weights.push_back(float(measurement.weight / scale));
  }
  summary->num_measured = NumMeasured(measurements);
  problem.is_free = Dilate(seen.is_seen, seen.places.neighbors, kBlendRings);
  return problem;
}

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

void AddRims(const ViewSet& views,
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

// Solves, and moves the vertices along.
void MovePlaces(SeenSurface seen,
                OffsetProblem problem,
                bool smooths,
                double pixel,
                const RefineOptions& options,
                const Context& context,
                IndexedMesh* mesh,
                RoundSummary* summary) {
  const VertexCorners& neighbors = seen.places.neighbors;
  const PlacePlanes planes = FitPlacePlanes(seen.surfaces, neighbors);
  problem.shares = planes.shares;
  for (const float spacing : planes.spacings) {
    problem.spacings.push_back(float(spacing / pixel));
  }
  const double mean_spacing =
      std::max(MeanSpacing(*mesh, seen.places), seen.edge);
  const SolveOffsetsOptions solving{.smoothness = options.smoothness,
                                    .outlier_scale = options.outlier_scale};
  MovedPlaces moved;
  moved.offsets = SolveOffsets(problem, neighbors, solving, context);
  for (double& offset : moved.offsets) {
    offset *= pixel;
  }
  moved.slopes = planes.Slopes(moved.offsets, neighbors);
  moved.surfaces = std::move(seen.surfaces);
  moved.is_free = std::move(problem.is_free);
  moved.is_smooth = std::move(seen.is_seen);
  if (!smooths) {
    moved.is_smooth.assign(moved.is_smooth.size(), 0);
  }
  summary->mean_displacement =
      MoveVertices(seen.places, moved, kReach * mean_spacing, context, mesh) /
      pixel;
}

}  // namespace

RoundSummary RefineOnce(const std::vector<Eigen::Vector3d>& start,
                        const VertexCorners& neighbors,
                        double pixel,
                        const RoundPlan& plan,
                        const RefineOptions& options,
                        const Context& context,
                        ViewSet* views,
                        IndexedMesh* mesh) {
  RoundSummary summary;
  summary.scale = plan.scale;
  summary.range = plan.range * plan.scale;
  const std::vector<Eigen::Vector3d> before = mesh->positions;
  SeenSurface seen =
      LookAtSurface(*views,
                    neighbors,
                    {.pixel = pixel,
                     .scale = plan.scale,
                     .spacing = options.measure_spacing * plan.scale * pixel},
                    options,
                    context,
                    mesh);
  summary.num_places = seen.choices.size();
  summary.num_seen = seen.NumSeen();
  summary.fit_seconds = seen.fit_seconds;
  summary.view_seconds = seen.view_seconds;
  Stopwatch stopwatch;
  if (plan.aligns) {
    Align(seen, options, context, views, &summary);
  }
  summary.alignment_seconds = stopwatch.Lap();
  std::vector<OffsetMeasurement> measurements = MeasureOffsets(
      *views,
      seen,
      plan,
      options,
      fmt::format("refinement: offsets up to {:.2g} pixels", summary.range),
      context);
  if (plan.scale == 1) {
    DropChanceOffsets(seen.places.neighbors,
                      seen.is_seen,
                      kSupportTolerance * pixel,
                      context,
                      &measurements);
  }
  OffsetProblem problem =
      MakeProblem(seen, measurements, pixel, plan.scale, &summary);
  summary.search_seconds = stopwatch.Lap();
  summary.border_shift = plan.border_shift;
  if (options.silhouette_weight > 0) {
    AddRims(*views,
            seen,
            measurements,
            pixel,
            plan,
            options,
            context,
            &problem,
            &summary);
  }
  summary.silhouette_seconds = stopwatch.Lap();
  MovePlaces(std::move(seen),
             std::move(problem),
             plan.smooths,
             pixel,
             options,
             context,
             mesh,
             &summary);
  summary.solve_seconds = stopwatch.Lap();
  // In each round: what is moved back would stay a pit, and the next round
  // makes it smooth.
  const double tolerance =
      options.hull_tolerance + std::max(0.0, -summary.border_shift);
  summary.num_withdrawn = KeepValid(
      *views, neighbors, start, before, tolerance, pixel, context, mesh);
  summary.validity_seconds = stopwatch.Lap();
  return summary;
}

double MeanAgreement(const ViewSet& views,
                     const VertexCorners& neighbors,
                     double pixel,
                     const RefineOptions& options,
                     const Context& context,
                     IndexedMesh* mesh) {
  const SeenSurface seen =
      LookAtSurface(views,
                    neighbors,
                    {.pixel = pixel,
                     .scale = 1,
                     .spacing = 2 * options.measure_spacing * pixel},
                    options,
                    context,
                    mesh);
  double sum = 0;
  for (const OffsetMeasurement& measurement :
       MeasureOffsets(views,
                      seen,
                      RoundPlan(),
                      options,
                      "refinement: agreement of the views",
                      context)) {
    sum += measurement.score_before;
  }
  return sum / double(std::max<size_t>(seen.NumSeen(), 1));
}

}  // namespace octacut
