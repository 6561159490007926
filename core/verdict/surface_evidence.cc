#include "core/verdict/surface_evidence.h"

#include <algorithm>
#include <Eigen/Core>
#include <optional>
#include <utility>

#include "core/base/parallel.h"
#include "core/mesh/triangle_normal.h"
#include "core/mesh/vertex_corners.h"
#include "core/refine/offset_search.h"
#include "core/refine/seen_surface.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 1024;
// The range of the search for a better offset, pixels: twice as far as a
// surface may lie that counts as measured, so that a peak there has both its
// sides.
constexpr double kRange = 2;

std::vector<float> AreasOfPoints(const IndexedMesh& mesh,
                                 const SurfacePoints& points) {
  std::vector<float> areas(points.vertices.size());
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    const double area = TriangleArea(mesh, triangle);
    for (const uint32_t corner : triangle) {
      areas[points.point_of[corner]] += float(area / 3);
    }
  }
  return areas;
}

// Pixels from the border of a silhouette within which a point is at it.
constexpr float kAtBorder = 1.5f;

void MeasureHull(const ViewSet& views,
                 float border_shift,
                 PointEvidence* value) {
  value->hull_distance = Silhouette::kFarInside;
  for (const PreparedView& view : views) {
    if (const std::optional<ProjectedPoint> p =
            view.projection.ProjectIntoFrame(value->position)) {
      const float distance =
          view.silhouette.SignedDistance(p->u, p->v) - border_shift;
      value->hull_distance = std::min(value->hull_distance, distance);
      value->num_contours += distance <= kAtBorder;
    }
  }
}

}  // namespace

SurfaceEvidence MeasureSurfaceEvidence(const ViewSet& views,
                                       const SurfaceEvidenceOptions& options,
                                       const Context& context,
                                       IndexedMesh* mesh) {
  const VertexCorners neighbors =
      FindVertexNeighbors(mesh->positions.size(), mesh->triangles);
  const double pixel = PixelSizeAt(views, *mesh);
  SeenSurface seen = LookAtSurface({.views = views,
                                    .neighbors = neighbors,
                                    .options = options.refinement,
                                    .pixel = pixel,
                                    .scale = 1,
                                    .spacing = options.spacing * pixel},
                                   context,
                                   mesh);
  const size_t count = seen.surfaces.size();
  Phase phase(context, "check of the surface against the photographs", count);
  const std::vector<OffsetMeasurement> offsets =
      SearchOffsets(views,
                    seen.surfaces,
                    seen.choices,
                    MakeOffsetSearch(options.refinement, kRange, 1),
                    context,
                    &phase);
  const std::vector<float> areas = AreasOfPoints(*mesh, seen.points);
  std::vector<PointEvidence> values(count);
  ParallelEach(context, count, kGrain, [&](size_t i) {
    PointEvidence& value = values[i];
    value.position = mesh->positions[seen.points.vertices[i]].cast<float>();
    value.normal = seen.surfaces[i].normal;
    value.area = areas[i];
    value.num_views = seen.choices[i].count;
    if (offsets[i].is_measured) {
      value.agreement = offsets[i].score_before;
    }
    if (offsets[i].weight > 0) {
      // From the vertex, not from the surface that was fitted to it.
      value.offset =
          (offsets[i].offset + seen.surfaces[i].height) / seen.choices[i].pixel;
      value.precision = offsets[i].weight;
    }
    value.curvature =
        -float(pixel) * (seen.surfaces[i].uu + seen.surfaces[i].vv);
    MeasureHull(views, float(options.border_shift), &value);
  });
  return {
      std::move(seen.rays), std::move(seen.points), std::move(values), pixel};
}

}  // namespace octacut
