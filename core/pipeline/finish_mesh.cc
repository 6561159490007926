#include "core/pipeline/finish_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/check_option.h"
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

}  // namespace

void FinishOptions::Check() const {
  smoothing.Check();
  CheckOption(min_component >= 0 && min_component <= 1,
              "min_component",
              min_component,
              "must be in 0 .. 1");
  CheckOption(min_handle >= 0 && min_handle <= 64,
              "min_handle",
              min_handle,
              "must be in 0 .. 64");
}

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
                       const FinishOptions& options,
                       const Context& context) {
  FinishSummary summary;
  ExtractedSurface extracted =
      ExtractSurface(surface.voxels, surface.labels, cube, context);
  summary.extraction = extracted.summary;
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
  summary.num_removed_components = kept.summary.num_removed;
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
  summary.handles = cleaned.summary;
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
  return {std::move(smoothed.mesh), std::move(kept.removed), summary};
}

}  // namespace octacut
