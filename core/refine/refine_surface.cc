#include "core/refine/refine_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/mesh/normals.h"
#include "core/mesh/untangle.h"
#include "core/raycast/unit_mesh.h"
#include "core/refine/agreement.h"
#include "core/refine/keep_valid.h"
#include "core/refine/narrow_rounds.h"
#include "core/refine/seen_surface.h"

namespace octacut {
namespace {

std::vector<RoundPlan> PlanCoarseRounds(const RefineOptions& options) {
  std::vector<RoundPlan> plan;
  for (int pass = 0; pass < options.coarse_passes; ++pass) {
    for (int i = options.coarse_rounds; i > 0; --i) {
      // The first pass has taken the steps of the voxels; to smooth coarsely
      // once more would only take edges. Before, and on coarser images, the
      // surface is not good enough to align the views.
      const bool later = pass > 0;
      plan.push_back({.scale = double(1 << i),
                      .range = RefineOptions::kRange,
                      .smooths = !later,
                      .aligns = later && i == 1});
    }
  }
  return plan;
}

std::vector<RoundPlan> PlanFineRounds() {
  std::vector<RoundPlan> plan;
  double range = RefineOptions::kRange;
  for (int i = 0; i < RefineOptions::kFineRounds; ++i) {
    plan.push_back({.range = range, .aligns = true});
    // A peak needs a neighbour on both sides.
    range = std::max(range / 2, 2 * RefineOptions::kStep);
  }
  return plan;
}

void CheckInput(const IndexedMesh& mesh, const ViewSet& views) {
  if (mesh.triangles.empty()) {
    throw InputError("refinement: the mesh has no triangles");
  }
  if (views.size() < 2) {
    throw InputError("refinement: at least 2 views are needed");
  }
  for (const PreparedView& view : views) {
    if (view.pyramid.NumLevels() == 0) {
      throw InputError("refinement: a view has no image");
    }
  }
}

std::vector<Eigen::Vector3d> SomePositions(const IndexedMesh& mesh) {
  const size_t stride = std::max<size_t>(mesh.positions.size() / 1000, 1);
  std::vector<Eigen::Vector3d> some;
  for (size_t v = 0; v < mesh.positions.size(); v += stride) {
    some.push_back(mesh.positions[v]);
  }
  return some;
}

// Moves `mesh` from `start` to `after`, unit coordinates, to positions as files
// keep them. Those of the rounds are valid in doubles alone: what the rounding
// makes intersect goes back towards where the mesh has been given. Returns how
// many vertices do.
size_t MoveMesh(const std::vector<Eigen::Vector3d>& start,
                const std::vector<Eigen::Vector3d>& after,
                const BoundingCube& cube,
                double pixel_size,
                const Context& context,
                IndexedMesh* mesh) {
  const std::vector<Eigen::Vector3d> given = mesh->positions;
  for (size_t v = 0; v < start.size(); ++v) {
    if (after[v] != start[v]) {
      mesh->positions[v] =
          RoundedToFloats(cube.min_corner + cube.edge * after[v]);
    }
  }
  return KeepFloatsValid(given, pixel_size, context, mesh);
}

void SummarizeMoves(const std::vector<Eigen::Vector3d>& start,
                    const IndexedMesh& mesh,
                    double pixel,
                    RefineSummary* summary) {
  summary->num_vertices = start.size();
  for (size_t v = 0; v < start.size(); ++v) {
    if (mesh.positions[v] != start[v]) {
      const double displacement = (mesh.positions[v] - start[v]).norm() / pixel;
      ++summary->num_moved;
      summary->mean_displacement += displacement;
      summary->max_displacement =
          std::max(summary->max_displacement, displacement);
    }
  }
  summary->mean_displacement /= double(std::max<size_t>(summary->num_moved, 1));
}

void ReportBorders(const RefineSummary& summary, const Context& context) {
  context.Info(
      fmt::format("Refinement estimates that all masks are {0:.2f} pixels too "
                  "{2}, and corrects for it (a pixel covers {1:.3g} units on "
                  "the surface).",
                  std::abs(summary.border_shift),
                  summary.pixel_size,
                  summary.border_shift < 0 ? "small" : "large"));
}

// The rounds of one refinement.
class Rounds {
 public:
  // `mesh` is in unit coordinates.
  Rounds(const RoundInputs& inputs,
         const Context& context,
         ViewSet* views,
         IndexedMesh* mesh,
         RefineSummary* summary)
      : inputs_(inputs),
        context_(context),
        views_(*views),
        mesh_(*mesh),
        summary_(*summary),
        edge_shift_(views->front().border_shift),
        edge_shift_slack_(views->front().border_shift_slack) {
    agreement_ = Timed(&agreement_seconds_, [&] { return Agreement(); });
    summary_.agreement_before = agreement_.Mean();
    summary_.border_shift = edge_shift_;
  }

  void RunCoarse() {
    const std::vector<RoundPlan> plans = PlanCoarseRounds(inputs_.options);
    Phase phase(context_, "coarse refinement", plans.size());
    for (const RoundPlan& plan : plans) {
      Run(plan);
      phase.Advance();
    }
  }

  void RunFine() {
    const std::vector<RoundPlan> plans = PlanFineRounds();
    Phase phase(context_, "refinement", plans.size() + 1);
    for (const RoundPlan& plan : plans) {
      Run(plan);
      phase.Advance();
    }
    RoundPlan narrow = Completed(plans.back());
    narrow.aligns = false;
    RefineNarrowParts(
        inputs_, narrow, context_, &views_, &mesh_, &summary_.rounds);
    phase.Advance();
    for (const RoundSummary& round : summary_.rounds) {
      summary_.num_withdrawn += round.num_withdrawn;
    }
    summary_.agreement_after = Agreement().Mean();
  }

 private:
  SurfaceAgreement Agreement() const {
    return MeasureAgreement(
        {views_, inputs_.neighbors, inputs_.options, inputs_.pixel},
        context_,
        &mesh_);
  }

  // With what the rounds before have found.
  RoundPlan Completed(RoundPlan plan) const {
    // Coarse images of glossy objects agree by chance, and poses that are
    // aligned by them get worse.
    plan.aligns &=
        !summary_.rounds.empty() &&
        std::all_of(summary_.rounds.begin(),
                    summary_.rounds.end(),
                    [](const auto& round) { return round.KnowsMost(); });
    plan.edge_shift = edge_shift_;
    plan.edge_shift_slack = edge_shift_slack_;
    plan.border_shift = summary_.border_shift;
    return plan;
  }

  void Run(const RoundPlan& given) {
    const RoundPlan plan = Completed(given);
    if (plan.CanHarm() && !summary_.rounds.empty()) {
      agreement_ = Timed(&agreement_seconds_, [&] { return Agreement(); });
    }
    RoundSummary round =
        RefineOnce(inputs_, plan, &agreement_, context_, &views_, &mesh_);
    round.agreement_seconds += std::exchange(agreement_seconds_, 0);
    summary_.border_shift = round.border_shift;
    summary_.rounds.push_back(round);
  }

  const RoundInputs& inputs_;
  const Context& context_;
  ViewSet& views_;
  IndexedMesh& mesh_;
  RefineSummary& summary_;
  const double edge_shift_;
  const double edge_shift_slack_;
  SurfaceAgreement agreement_;  // before the next round
  double agreement_seconds_ = 0;
};

}  // namespace

RefinedSurface RefineSurface(IndexedMesh mesh,
                             const BoundingCube& cube,
                             const RefineOptions& options,
                             const Context& context,
                             ViewSet* views) {
  const auto always = [](const std::vector<Eigen::Vector3d>&) { return true; };
  return RefineSurfaceIf(always, std::move(mesh), cube, options, context, views)
      .value();
}

std::optional<RefinedSurface> RefineSurfaceIf(const CoarseCheck& goes_on,
                                              IndexedMesh mesh,
                                              const BoundingCube& cube,
                                              const RefineOptions& options,
                                              const Context& context,
                                              ViewSet* views) {
  options.Check();
  CheckInput(mesh, *views);
  Stopwatch whole;
  RefineSummary summary;
  IndexedMesh unit = UnitMesh(mesh, cube);
  const std::vector<Eigen::Vector3d> start = unit.positions;
  const VertexCorners neighbors =
      FindVertexNeighbors(start.size(), unit.triangles);
  const double pixel = PixelSizeAt(*views, unit);
  if (!(pixel > 0)) {
    throw InputError(
        "refinement: no view sees the mesh, because it lies behind all "
        "cameras");
  }
  summary.pixel_size = pixel * cube.edge;
  const std::vector<ViewProjection> projections = Projections(*views);
  const RoundInputs inputs{start, neighbors, pixel, options};
  Rounds rounds(inputs, context, views, &unit, &summary);
  rounds.RunCoarse();
  if (!goes_on(unit.positions)) {
    SetProjections(projections, views);
    return std::nullopt;
  }
  rounds.RunFine();
  summary.view_motion =
      MeasureViewMotion(projections, *views, SomePositions(unit));
  SummarizeMoves(start, unit, pixel, &summary);
  summary.num_withdrawn +=
      MoveMesh(start, unit.positions, cube, summary.pixel_size, context, &mesh);
  ReportBorders(summary, context);
  mesh.normals = ComputeVertexNormals(mesh, context);
  summary.seconds = whole.Lap();
  return RefinedSurface{std::move(mesh), std::move(summary)};
}

size_t EstimateRefinementBytes(size_t num_vertices) {
  // Mesh, boxes, rays, points and their equations, as measured.
  constexpr size_t kBytesPerVertex = 1000;
  return num_vertices * kBytesPerVertex;
}

}  // namespace octacut
