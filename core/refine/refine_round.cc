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
  return sum / double(std::max<size_t>(points.neighbors.entries.size(), 1));
}

// Returns how many views the last step has aligned.
size_t Align(const SeenSurface& seen,
             const RefineOptions& options,
             const Context& context,
             ViewSet* views) {
  const Phase phase(context, "refinement: pose alignment");
  size_t num_aligned = 0;
  for (int i = 0; i < options.alignment_steps; ++i) {
    num_aligned =
        AlignViews(seen.surfaces, seen.choices, options.patch, context, views);
  }
  return num_aligned;
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

SeenSurface LookAt(const ViewSet& views,
                   const RoundPlan& plan,
                   const RoundInputs& inputs,
                   const Context& context,
                   IndexedMesh* mesh) {
  const double spacing =
      RefineOptions::kMeasureSpacing * plan.scale * inputs.pixel;
  return LookAtSurface({.views = views,
                        .neighbors = inputs.neighbors,
                        .options = inputs.options,
                        .pixel = inputs.pixel,
                        .scale = plan.scale,
                        .spacing = spacing,
                        .part = inputs.part},
                       context,
                       mesh);
}

std::vector<ContourTarget> FindContours(const ViewSet& views,
                                        const SeenSurface& seen,
                                        const RoundPlan& plan,
                                        const Context& context) {
  return FindContourTargets(
      views,
      seen.rays,
      seen.surfaces,
      seen.points.neighbors,
      {.range = plan.range * plan.scale, .border_shift = plan.border_shift},
      context);
}

// What photographs and masks say of the surface that is seen; lengths in
// pixels.
OffsetProblem MakeProblem(const SeenSurface& seen,
                          const std::vector<OffsetMeasurement>& measurements,
                          const std::vector<ContourTarget>& contours,
                          const BorderVerdict& borders,
                          const RoundPlan& plan,
                          const RoundInputs& inputs) {
  const double pixel = inputs.pixel;
  OffsetProblem problem;
  for (size_t i = 0; i < measurements.size(); ++i) {
    const OffsetMeasurement& measurement = measurements[i];
    problem.normals.push_back(seen.surfaces[i].normal);
    problem.targets.push_back(float(measurement.offset / pixel));
    problem.weights.push_back(float(measurement.weight / plan.scale));
  }
  AddContourTargets(contours,
                    pixel,
                    RefineOptions::kSilhouetteWeight * borders.contour_weight,
                    &problem);
  problem.is_free = Dilate(seen.is_seen, seen.points.neighbors, kBlendRings);
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
      .outlier_scale = RefineOptions::kOutlierScale};
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
                        const SurfaceAgreement* agreement,
                        const Context& context,
                        ViewSet* views,
                        IndexedMesh* mesh) {
  RoundSummary summary;
  summary.scale = plan.scale;
  summary.range = plan.range * plan.scale;
  const std::vector<Eigen::Vector3d> before = mesh->positions;
  SeenSurface seen = Timed(&summary.look_seconds, [&] {
    return LookAt(*views, plan, inputs, context, mesh);
  });
  summary.num_points = seen.choices.size();
  summary.num_seen = seen.NumSeen();
  if (plan.aligns) {
    summary.num_aligned = Timed(&summary.alignment_seconds, [&] {
      return Align(seen, inputs.options, context, views);
    });
  }
  const std::vector<OffsetMeasurement> measurements = Timed(
      &summary.search_seconds,
      [&] { return MeasureOffsets(*views, seen, plan, inputs, context); });
  summary.num_measured = NumMeasured(measurements);
  const std::vector<ContourTarget> contours =
      Timed(&summary.silhouette_seconds,
            [&] { return FindContours(*views, seen, plan, context); });
  summary.num_contour_targets = contours.size();
  const BorderVerdict borders = JudgeBorders(
      contours, seen.surfaces, measurements, plan, summary.KnowsMost());
  summary.border_shift = borders.shift;
  summary.hull_tolerance = borders.hull_tolerance;
  OffsetProblem problem =
      MakeProblem(seen, measurements, contours, borders, plan, inputs);
  summary.mean_displacement = Timed(&summary.solve_seconds, [&] {
    return MovePoints(std::move(seen),
                      std::move(problem),
                      plan.smooths,
                      inputs,
                      context,
                      mesh);
  });
  if (plan.CanHarm()) {
    summary.taken_back = Timed(&summary.agreement_seconds, [&] {
      return TakeBackHarm(
                 {*views, inputs.neighbors, inputs.options, inputs.pixel},
                 before,
                 *agreement,
                 context,
                 mesh)
          .mean;
    });
  }
  // In each round: what is moved back would stay a pit, and the next round
  // makes it smooth.
  summary.num_withdrawn = Timed(&summary.validity_seconds, [&] {
    return KeepValid(
        *views,
        inputs.neighbors,
        {inputs.start, before, summary.MaskTolerance(), inputs.pixel},
        context,
        mesh);
  });
  return summary;
}

}  // namespace octacut
