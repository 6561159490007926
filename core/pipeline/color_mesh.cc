#include "core/pipeline/color_mesh.h"

#include <cmath>
#include <optional>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kVertexGrain = 1024;
constexpr uint8_t kUnseenGrey = 128;

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
