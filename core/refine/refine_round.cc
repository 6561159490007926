#include "core/refine/refine_round.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/refine/align_views.h"
#include "core/refine/border_terms.h"
#include "core/refine/keep_valid.h"
#include "core/refine/move_vertices.h"
#include "core/refine/neighbor_planes.h"
#include "core/refine/offset_search.h"
#include "core/refine/offset_support.h"
#include "core/refine/seen_surface.h"
#include "core/refine/solve_offsets.h"

namespace octacut {
namespace {

// Rings of unseen points around seen ones that may move along with them.
constexpr int kBlendRings = 2;
// By how much offsets a few patches apart may differ and still mean the same
// surface, pixels of the round.
constexpr double kSupportTolerance = 1;
// How far a point speaks of vertices, in distances between points.
constexpr double kReach = 1.3;

// Mean distance between neighbouring points.
double MeanSpacing(const IndexedMesh& mesh, const SurfacePoints& points) {
  double sum = 0;
  for (size_t i = 0; i < points.vertices.size(); ++i) {
    for (const uint32_t next : points.neighbors.Of(i)) {
      sum += (mesh.positions[points.vertices[i]] -
              mesh.positions[points.vertices[next]])
                 .norm();
    }
  }
  return sum / double(std::max<size_t>(points.neighbors.corners.size(), 1));
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

// Offsets of the fitted surfaces that others support.
std::vector<OffsetMeasurement> MeasureOffsets(const ViewSet& views,
                                              const SeenSurface& seen,
                                              const RoundPlan& plan,
                                              const RoundInputs& inputs,
                                              const Context& context) {
  const OffsetSearch search =
      MakeOffsetSearch(inputs.options, plan.range, plan.scale);
  Phase phase(
      context,
      fmt::format("refinement: offsets up to {:.2g} pixels", search.range),
      seen.surfaces.size());
  std::vector<OffsetMeasurement> measurements = SearchOffsets(
      views, seen.surfaces, seen.choices, search, context, &phase);
  DropChanceOffsets(seen.points.neighbors,
                    seen.is_seen,
                    kSupportTolerance * plan.scale * inputs.pixel,
                    context,
                    &measurements);
  return measurements;
}

// Lengths in pixels.
OffsetProblem MakeOffsetTerms(
    const SeenSurface& seen,
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
  problem.is_free = Dilate(seen.is_seen, seen.points.neighbors, kBlendRings);
  return problem;
}

// What photographs and masks say of the surface that is seen.
OffsetProblem MakeProblem(const ViewSet& views,
                          const SeenSurface& seen,
                          const RoundPlan& plan,
                          const RoundInputs& inputs,
                          const Context& context,
                          RoundSummary* summary) {
  Stopwatch stopwatch;
  const std::vector<OffsetMeasurement> measurements =
      MeasureOffsets(views, seen, plan, inputs, context);
  OffsetProblem problem =
      MakeOffsetTerms(seen, measurements, inputs.pixel, plan.scale, summary);
  summary->search_seconds = stopwatch.Lap();
  summary->border_shift = plan.border_shift;
  summary->hull_tolerance = kLargestHullTolerance;
  const RefineOptions& options = inputs.options;
  if (options.silhouette_weight > 0) {
    const std::vector<ContourTarget> contours = FindContourTargets(
        views,
        seen.rays,
        seen.surfaces,
        seen.points.neighbors,
        {.range = summary->range, .border_shift = plan.border_shift},
        context);
    JudgeBorders(contours, seen.surfaces, measurements, plan, summary);
    AddContourTargets(
        contours, inputs.pixel, options.silhouette_weight, &problem);
  }
  summary->silhouette_seconds = stopwatch.Lap();
  return problem;
}

// Solves, and moves the vertices along. Returns the mean way of those that may
// move, pixels.
double MovePoints(SeenSurface seen,
                  OffsetProblem problem,
                  bool smooths,
                  const RoundInputs& inputs,
                  const Context& context,
                  IndexedMesh* mesh) {
  const double pixel = inputs.pixel;
  const VertexCorners& neighbors = seen.points.neighbors;
  const NeighborPlanes planes = FitNeighborPlanes(seen.surfaces, neighbors);
  problem.shares = planes.shares;
  for (const float spacing : planes.spacings) {
    problem.spacings.push_back(float(spacing / pixel));
  }
  const double mean_spacing =
      std::max(MeanSpacing(*mesh, seen.points), seen.edge);
  const SolveOffsetsOptions solving{
      .smoothness = inputs.options.smoothness,
      .outlier_scale = inputs.options.outlier_scale};
  MovedPoints moved;
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
  return MoveVertices(
             seen.points, moved, kReach * mean_spacing, context, mesh) /
         pixel;
}

}  // namespace

RoundSummary RefineOnce(const RoundInputs& inputs,
                        const RoundPlan& plan,
                        const SurfaceAgreement& agreement,
                        const Context& context,
                        ViewSet* views,
                        IndexedMesh* mesh) {
  const RefineOptions& options = inputs.options;
  const double pixel = inputs.pixel;
  RoundSummary summary;
  summary.scale = plan.scale;
  summary.range = plan.range * plan.scale;
  const std::vector<Eigen::Vector3d> before = mesh->positions;
  Stopwatch stopwatch;
  SeenSurface seen =
      LookAtSurface({.views = *views,
                     .neighbors = inputs.neighbors,
                     .options = options,
                     .pixel = pixel,
                     .scale = plan.scale,
                     .spacing = options.measure_spacing * plan.scale * pixel},
                    context,
                    mesh);
  summary.num_points = seen.choices.size();
  summary.num_seen = seen.NumSeen();
  summary.fit_seconds = seen.fit_seconds;
  summary.view_seconds = seen.view_seconds;
  stopwatch.Lap();
  if (plan.aligns) {
    Align(seen, options, context, views, &summary);
  }
  summary.alignment_seconds = stopwatch.Lap();
  OffsetProblem problem =
      MakeProblem(*views, seen, plan, inputs, context, &summary);
  stopwatch.Lap();
  summary.mean_displacement = MovePoints(
      std::move(seen), std::move(problem), plan.smooths, inputs, context, mesh);
  summary.solve_seconds = stopwatch.Lap();
  if (plan.CanHarm()) {
    summary.taken_back =
        TakeBackHarm({*views, inputs.neighbors, pixel, options},
                     before,
                     agreement,
                     context,
                     mesh);
  }
  summary.agreement_seconds = stopwatch.Lap();
  // In each round: what is moved back would stay a pit, and the next round
  // makes it smooth.
  const double tolerance =
      summary.hull_tolerance + std::max(0.0, -summary.border_shift);
  summary.num_withdrawn = KeepValid(*views,
                                    inputs.neighbors,
                                    {inputs.start, before, tolerance, pixel},
                                    context,
                                    mesh);
  summary.validity_seconds = stopwatch.Lap();
  return summary;
}

}  // namespace octacut
