#include "core/pipeline/finish_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

// What lies this deep in the silhouettes of all views shows in none of them: by
// any masks, and by those whose borders are known to `border_shift_slack`. In
// voxels, or pixels where these are larger.
constexpr float kDeepInMasks = 4;
constexpr float kInsideMasks = 1;
// The longest loops around such handles, in units of `min_handle`
// (docs/experiments/handles.md).
constexpr double kDeepHandle = 4;
constexpr double kInsideHandle = 2;
// Masks that are too large by more than so many pixels close gaps, of which
// bridges are left where their borders are moved back.
constexpr float kClosingShift = 1;

bool ClosesGaps(const PreparedView& view) {
  return view.border_shift > kClosingShift &&
         std::isfinite(view.border_shift_slack);
}

// The longest loop through a point that is cut because no silhouette shows it,
// or none that can be trusted to, in units of `min_handle`; 0 where one may.
// `point` and `voxel` are in unit coordinates.
double LongestHidden(const ViewSet& views,
                     const Eigen::Vector3f& point,
                     float voxel) {
  bool is_deep = true;
  for (const PreparedView& view : views) {
    const std::optional<ProjectedPoint> p =
        view.projection.ProjectIntoFrame(point);
    if (!p) {
      continue;
    }
    const float unit =
        std::max(1.0f, view.projection.Footprint(voxel, p->depth));
    const float depth = view.DistanceInside(*p) / unit;
    is_deep = is_deep && depth > kDeepInMasks;
    if (depth <=
        std::min(kDeepInMasks, kInsideMasks + view.border_shift_slack)) {
      return ClosesGaps(view) ? kInsideHandle : 0;
    }
  }
  return is_deep ? kDeepHandle : kInsideHandle;
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
      ExtractSurface(surface.voxels, surface.labels, cube, context), context);
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
  const double voxel_size = cube.VoxelSize(surface.voxels.Level());
  KeptComponents kept = KeepLargestComponents(
      PositionVertices(std::move(extracted), context), options.min_component);
  const size_t num_needed =
      RestoreNeededComponents(views, cube, context, &kept);
  if (num_needed > 0) {
    context.Info(fmt::format(
        "{} components smaller than `min_component` are kept: the silhouettes "
        "are not covered without them.",
        num_needed));
  }
  summary.num_removed_components = kept.num_removed;
  // Below a pixel the images cannot tell a handle from none.
  const double pixel =
      cube.edge * PixelSize(views, Eigen::Vector3f::Constant(0.5f));
  const double max_length = options.min_handle * std::max(voxel_size, pixel);
  RemovedHandles cleaned = RemoveHandles(
      std::move(kept.mesh),
      {.max_length = max_length,
       .min_height = kMinTriangleHeight * voxel_size,
       .max_length_at =
           [&](const Eigen::Vector3d& point) {
             return max_length * LongestHidden(views,
                                               cube.ToUnit(point).cast<float>(),
                                               float(voxel_size / cube.edge));
           },
       .max_length_anywhere = kDeepHandle * max_length},
      context);
  summary.handles = cleaned.summary;
  std::vector<Eigen::Vector3d> before = cleaned.mesh.positions;
  IndexedMesh smoothed = SmoothSurface(
      std::move(cleaned.mesh), voxel_size, options.smoothing, context);
  // Smoothing leaves nothing that intersects, but in doubles.
  RoundToFloats(&before);
  RoundToFloats(&smoothed.positions);
  UntangleFloats(before, kMinTriangleHeight * voxel_size, context, &smoothed);
  smoothed.normals = ComputeVertexNormals(smoothed, context);
  return {std::move(smoothed), std::move(kept.removed), summary};
}

}  // namespace octacut
