#include "core/pipeline/finish_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/extract/extract_surface.h"
#include "core/extract/position_vertices.h"
#include "core/handles/remove_handles.h"
#include "core/mesh/keep_components.h"
#include "core/mesh/normals.h"
#include "core/mesh/smooth.h"
#include "core/mesh/untangle.h"
#include "core/pipeline/needed_components.h"

namespace octacut {
namespace {

constexpr size_t kVertexGrain = 1024;
constexpr uint8_t kUnseenGrey = 128;

// Points this deep in the visual hull show in no silhouette. In voxels, or
// pixels where these are larger.
constexpr float kDeepInHull = 4;
// The longest loop around a handle that no silhouette shows, in units of
// `min_handle` (docs/experiments/handles.md).
constexpr double kHiddenHandle = 4;

// Deep in the silhouettes of all views that have the point in their frames.
// `point` and `voxel` are in unit coordinates.
bool IsHiddenFromSilhouettes(const ViewSet& views,
                             const Eigen::Vector3f& point,
                             float voxel) {
  return std::all_of(views.begin(), views.end(), [&](const PreparedView& view) {
    const std::optional<ProjectedPoint> p =
        view.projection.ProjectIntoFrame(point);
    return !p ||
           view.DistanceInside(*p) >
               kDeepInHull *
                   std::max(1.0f, view.projection.Footprint(voxel, p->depth));
  });
}

// Mean colour of the selected views at a point.
SurfaceMesh::Color BlendColor(const ViewSet& views,
                              const Visibility::Selection& selection,
                              const Eigen::Vector3f& point,
                              float spacing) {
  Float4 sum = {0, 0, 0, 0};
  float weights = 0;
  for (int i = 0; i < selection.count; ++i) {
    const PreparedView& view = views[selection.views[i].view];
    const std::optional<ProjectedPoint> p = view.projection.Project(point);
    if (!p) {
      continue;
    }
    const Float4 color =
        view.pyramid
            .LevelForFootprint(view.projection.Footprint(spacing, p->depth))
            .Sample(p->u, p->v);
    sum += color * selection.views[i].weight;
    weights += selection.views[i].weight;
  }
  if (weights == 0) {
    return {kUnseenGrey, kUnseenGrey, kUnseenGrey};
  }
  sum /= weights;
  const auto channel = [&](int i) { return uint8_t(std::lround(sum[i])); };
  return {channel(2), channel(1), channel(0)};  // blue, green, red in `sum`
}

}  // namespace

IndexedMesh PositionedMesh(const LabeledVoxels& surface,
                           const BoundingCube& cube,
                           const Context& context) {
  return PositionVertices(
             ExtractSurface(surface.voxels, surface.labels, cube, context),
             PositionVerticesOptions(),
             context)
      .mesh;
}

FinishedMesh FinalMesh(const ViewSet& views,
                       const LabeledVoxels& surface,
                       const BoundingCube& cube,
                       const ReconstructionOptions& options,
                       const Context& context,
                       ReconstructionSummary* summary) {
  ExtractedSurface extracted =
      ExtractSurface(surface.voxels, surface.labels, cube, context);
  summary->extraction = extracted.summary;
  if (extracted.mesh.triangles.empty()) {
    throw InputError(fmt::format(
        "the surface vanished: with ballooning = {} and neutral^smoothness = "
        "{:.3g}, no part of the visual hull is inside; raise `ballooning`",
        options.evidence.ballooning,
        std::pow(options.consistency.neutral, options.energy.smoothness)));
  }
  const PositionVerticesOptions placing;
  PositionedSurface positioned =
      PositionVertices(std::move(extracted), placing, context);
  const double voxel_size = cube.VoxelSize(surface.voxels.Level());
  KeptComponents kept =
      KeepLargestComponents(std::move(positioned.mesh), options.min_component);
  const size_t num_needed =
      RestoreNeededComponents(views, cube, context, &kept);
  if (num_needed > 0) {
    context.Info(fmt::format(
        "{} components smaller than `min_component` are kept: the silhouettes "
        "are not covered without them.",
        num_needed));
  }
  summary->num_removed_components = kept.summary.num_removed;
  // Below a pixel the images cannot tell a handle from none.
  const double pixel =
      cube.edge * PixelSize(views, Eigen::Vector3f::Constant(0.5f));
  const double max_length = options.min_handle * std::max(voxel_size, pixel);
  RemovedHandles cleaned = RemoveHandles(
      std::move(kept.mesh),
      {.max_length = max_length,
       .min_height = placing.min_height * voxel_size,
       .max_hidden_length = kHiddenHandle * max_length,
       .is_hidden =
           [&](const Eigen::Vector3d& point) {
             return IsHiddenFromSilhouettes(views,
                                            cube.ToUnit(point).cast<float>(),
                                            float(voxel_size / cube.edge));
           }},
      context);
  summary->handles = cleaned.summary;
  std::vector<Eigen::Vector3d> before = cleaned.mesh.positions;
  SmoothedSurface smoothed = SmoothSurface(
      std::move(cleaned.mesh), voxel_size, options.smoothing, context);
  // Smoothing leaves nothing that intersects, but in doubles.
  RoundToFloats(&before);
  RoundToFloats(&smoothed.mesh.positions);
  UntangleFloats(before,
                 options.smoothing.min_height * voxel_size,
                 context,
                 &smoothed.mesh);
  smoothed.mesh.normals = ComputeVertexNormals(smoothed.mesh, context);
  return {std::move(smoothed.mesh), std::move(kept.removed)};
}

SurfaceMesh ColoredMesh(const IndexedMesh& mesh,
                        const ViewSet& views,
                        const LabeledVoxels& surface,
                        const BoundingCube& cube,
                        const VisibilityOptions& options,
                        const Context& context) {
  SurfaceMesh colored = ToSurfaceMesh(mesh);
  Phase phase(context, "vertex colours", colored.n_vertices());
  const Visibility visibility = Visibility::Estimate(views,
                                                     surface.voxels,
                                                     surface.labels,
                                                     surface.voxels.Level(),
                                                     options,
                                                     context);
  const float spacing = 1.0f / float(surface.voxels.Resolution());
  if (!colored.has_vertex_colors()) {
    colored.request_vertex_colors();
  }
  ParallelFor(
      context,
      colored.n_vertices(),
      kVertexGrain,
      [&](size_t begin, size_t end) {
        for (size_t v = begin; v < end; ++v) {
          const SurfaceMesh::VertexHandle vertex{int(v)};
          const Eigen::Vector3f point =
              cube.ToUnit(colored.point(vertex)).cast<float>();
          const Eigen::Vector3f normal = colored.normal(vertex).cast<float>();
          colored.set_color(
              vertex,
              BlendColor(
                  views, visibility.Select(point, normal), point, spacing));
        }
        phase.Advance(end - begin);
      });
  return colored;
}

}  // namespace octacut
