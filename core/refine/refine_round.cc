#include "core/refine/refine_round.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/mesh/normals.h"
#include "core/raycast/ray_scene.h"
#include "core/refine/local_surface.h"
#include "core/refine/offset_search.h"
#include "core/refine/rim_targets.h"
#include "core/refine/solve_offsets.h"
#include "core/refine/spread_vertices.h"

namespace octacut {
namespace {

// Rings of unseen vertices around seen ones that may move along with them.
constexpr int kBlendRings = 8;
// Rays begin this far before the surface, in edges of the mesh.
constexpr double kClearance = 1.5;
// A piece of the surface needs some triangles, however large they are.
constexpr double kMinFitEdges = 2.5;

double MeanEdge(const IndexedMesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      sum +=
          (mesh.positions[triangle[i]] - mesh.positions[triangle[(i + 1) % 3]])
              .norm();
    }
  }
  return sum / double(3 * mesh.triangles.size());
}

std::vector<uint8_t> Dilate(std::vector<uint8_t> set,
                            const VertexCorners& neighbors,
                            int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<uint8_t> before = set;
    for (size_t v = 0; v < set.size(); ++v) {
      for (const uint32_t next : neighbors.Of(v)) {
        set[v] |= before[next];
      }
    }
  }
  return set;
}

// What is known of the surface before anything is measured.
struct SeenSurface {
  double edge;
  std::vector<LocalSurface> surfaces;
  RayScene rays;
  std::vector<ChosenViews> choices;
  std::vector<uint8_t> is_seen;  // by at least two views
};

SeenSurface LookAtSurface(const ViewSet& views,
                          const VertexCorners& neighbors,
                          double fit_radius,
                          const RefineOptions& options,
                          const Context& context,
                          IndexedMesh* mesh,
                          RoundSummary* summary) {
  Stopwatch stopwatch;
  mesh->normals = ComputeVertexNormals(*mesh, context);
  const double edge = MeanEdge(*mesh);
  SeenSurface seen{
      edge,
      FitLocalSurfaces(
          *mesh, neighbors, std::max(fit_radius, kMinFitEdges * edge), context),
      RayScene(*mesh),
      {},
      {}};
  summary->fit_seconds = stopwatch.Lap();
  seen.choices = ChooseViews(views,
                             seen.rays,
                             seen.surfaces,
                             kClearance * edge,
                             options.views,
                             context);
  for (const ChosenViews& chosen : seen.choices) {
    seen.is_seen.push_back(chosen.count >= 2);
    summary->num_seen += chosen.count >= 2 ? 1 : 0;
  }
  summary->view_seconds = stopwatch.Lap();
  return seen;
}

OffsetSearch MakeSearch(const RoundPlan& plan, const RefineOptions& options) {
  OffsetSearch search;
  search.range = plan.range * plan.scale;
  search.step = options.step * plan.scale;
  search.spacing = plan.scale;
  search.patch_radius = options.patch_radius;
  search.pixel_noise = options.pixel_noise;
  search.min_score = options.min_score;
  return search;
}

// Vertices and what smooth pieces say of them; nothing measured yet. Lengths
// in pixels.
OffsetProblem MakeProblem(const IndexedMesh& mesh,
                          const VertexCorners& neighbors,
                          const SeenSurface& seen,
                          double keep_bend,
                          double pixel) {
  const size_t count = mesh.positions.size();
  OffsetProblem problem;
  problem.positions.resize(count);
  problem.normals.resize(count);
  problem.targets.resize(count);
  problem.weights.resize(count);
  problem.bends.resize(count);
  std::vector<Eigen::Vector3d> smooth(count);
  for (size_t v = 0; v < count; ++v) {
    const LocalSurface& surface = seen.surfaces[v];
    problem.positions[v] = mesh.positions[v] / pixel;
    problem.normals[v] = surface.normal.cast<double>();
    problem.targets[v] = seen.is_seen[v] ? float(surface.height / pixel) : 0;
    smooth[v] = problem.positions[v] + problem.targets[v] * problem.normals[v];
  }
  for (size_t v = 0; v < count; ++v) {
    // Where nobody sees the surface it keeps its shape, steps and all.
    const auto& from = seen.is_seen[v] ? smooth : problem.positions;
    const std::span<const uint32_t> around = neighbors.Of(v);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const uint32_t next : around) {
      sum += from[next] - from[v];
    }
    problem.bends[v] = float((seen.is_seen[v] ? keep_bend : 1.0) *
                             problem.normals[v].dot(sum) /
                             double(std::max<size_t>(around.size(), 1)));
  }
  problem.is_free = Dilate(seen.is_seen, neighbors, kBlendRings);
  return problem;
}

void AddMeasurements(const std::vector<uint32_t>& vertices,
                     const std::vector<OffsetMeasurement>& measurements,
                     double pixel,
                     double scale,
                     OffsetProblem* problem,
                     RoundSummary* summary) {
  summary->num_tried = vertices.size();
  for (size_t i = 0; i < vertices.size(); ++i) {
    if (measurements[i].weight > 0) {
      problem->targets[vertices[i]] += float(measurements[i].offset / pixel);
      problem->weights[vertices[i]] = float(measurements[i].weight / scale);
      ++summary->num_measured;
    }
  }
}

void AddRimTargets(std::vector<EdgeTarget> targets,
                   const SeenSurface& seen,
                   double weight,
                   double pixel,
                   OffsetProblem* problem,
                   RoundSummary* summary) {
  for (EdgeTarget& target : targets) {
    const auto& [a, b] = target.vertices;
    const float height = (1 - target.fraction) * seen.surfaces[a].height +
                         target.fraction * seen.surfaces[b].height;
    target.target = float((target.target + height) / pixel);
    target.weight = float(weight);
  }
  summary->num_rim_targets = targets.size();
  problem->edge_targets = std::move(targets);
}

void Move(const OffsetProblem& problem,
          const std::vector<double>& offsets,
          double pixel,
          IndexedMesh* mesh,
          RoundSummary* summary) {
  size_t num_free = 0;
  for (size_t v = 0; v < offsets.size(); ++v) {
    if (problem.is_free[v]) {
      mesh->positions[v] += offsets[v] * pixel * problem.normals[v];
      summary->mean_displacement += std::abs(offsets[v]);
      ++num_free;
    }
  }
  summary->mean_displacement /= double(std::max<size_t>(num_free, 1));
}

}  // namespace

RoundSummary RefineOnce(const ViewSet& views,
                        const VertexCorners& neighbors,
                        double pixel,
                        const RoundPlan& plan,
                        const RefineOptions& options,
                        const Context& context,
                        IndexedMesh* mesh) {
  RoundSummary summary;
  summary.scale = plan.scale;
  summary.range = plan.range * plan.scale;
  const double round_pixel = plan.scale * pixel;
  const SeenSurface seen = LookAtSurface(views,
                                         neighbors,
                                         options.fit_radius * round_pixel,
                                         options,
                                         context,
                                         mesh,
                                         &summary);
  Stopwatch stopwatch;
  OffsetProblem problem =
      MakeProblem(*mesh, neighbors, seen, options.keep_bend, pixel);
  const std::vector<uint32_t> vertices = SpreadVertices(
      *mesh, neighbors, seen.is_seen, options.measure_spacing * round_pixel);
  {
    Phase phase(context,
                fmt::format("refinement within {:.2g} pixels", summary.range),
                vertices.size());
    AddMeasurements(vertices,
                    SearchOffsets(views,
                                  seen.surfaces,
                                  seen.choices,
                                  vertices,
                                  MakeSearch(plan, options),
                                  context,
                                  &phase),
                    pixel,
                    plan.scale,
                    &problem,
                    &summary);
  }
  summary.search_seconds = stopwatch.Lap();
  if (options.silhouette_weight > 0) {
    AddRimTargets(
        FindRimTargets(
            views, seen.rays, seen.surfaces, neighbors, summary.range, context),
        seen,
        options.silhouette_weight,
        pixel,
        &problem,
        &summary);
  }
  summary.silhouette_seconds = stopwatch.Lap();
  SolveOffsetsOptions solving;
  // A bend over an edge goes with the square of its length, and there are as
  // many fewer: so the weight means the same for any mesh.
  solving.smoothness = options.smoothness * pixel / seen.edge;
  solving.outlier_scale = options.outlier_scale;
  Move(problem,
       SolveOffsets(problem, neighbors, solving, context),
       pixel,
       mesh,
       &summary);
  summary.solve_seconds = stopwatch.Lap();
  return summary;
}

double MeanAgreement(const ViewSet& views,
                     const VertexCorners& neighbors,
                     double pixel,
                     const RefineOptions& options,
                     const Context& context,
                     IndexedMesh* mesh) {
  RoundSummary summary;
  const SeenSurface seen = LookAtSurface(views,
                                         neighbors,
                                         options.fit_radius * pixel,
                                         options,
                                         context,
                                         mesh,
                                         &summary);
  const std::vector<uint32_t> vertices = SpreadVertices(
      *mesh, neighbors, seen.is_seen, 2 * options.measure_spacing * pixel);
  Phase phase(context, "agreement of the views", vertices.size());
  const std::vector<OffsetMeasurement> measurements =
      SearchOffsets(views,
                    seen.surfaces,
                    seen.choices,
                    vertices,
                    MakeSearch({1, 0}, options),
                    context,
                    &phase);
  double sum = 0;
  for (const OffsetMeasurement& measurement : measurements) {
    sum += measurement.score_before;
  }
  return sum / double(std::max<size_t>(vertices.size(), 1));
}

}  // namespace octacut
