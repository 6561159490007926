#include "core/pipeline/color_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/parallel.h"

namespace octacut {
namespace {

using Color = SurfaceMesh::Color;
using Vertex = SurfaceMesh::VertexHandle;

constexpr size_t kVertexGrain = 1024;
// Of a mesh that no view sees.
constexpr uint8_t kUnseenGrey = 128;

// Mean colour of the selected views at a point.
std::optional<Color> BlendColor(const ViewSet& views,
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
    return std::nullopt;
  }
  sum /= weights;
  const auto channel = [&](int i) { return uint8_t(std::lround(sum[i])); };
  return Color(channel(2), channel(1), channel(0));  // `sum`: blue, green, red
}

// The mean colour of the neighbours that have one.
Color ColorAround(const SurfaceMesh& mesh,
                  const std::vector<uint8_t>& is_colored,
                  Vertex vertex) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (const Vertex neighbor : mesh.vv_range(vertex)) {
    if (is_colored[neighbor.idx()] != 0) {
      const Color& color = mesh.color(neighbor);
      sum += Eigen::Vector3d(color[0], color[1], color[2]);
      ++count;
    }
  }
  const auto channel = [&](int i) {
    return uint8_t(std::lround(sum[i] / count));
  };
  return {channel(0), channel(1), channel(2)};
}

// Gives the vertices without a colour those of the vertices around them, from
// their border inwards.
void FillUncolored(std::vector<uint8_t> is_colored, SurfaceMesh* mesh) {
  std::vector<Vertex> border;
  for (const Vertex vertex : mesh->vertices()) {
    if (is_colored[vertex.idx()] != 0) {
      border.push_back(vertex);
    }
  }
  while (!border.empty()) {
    std::vector<Vertex> next;
    std::vector<Color> colors;
    for (const Vertex colored : border) {
      for (const Vertex vertex : mesh->vv_range(colored)) {
        if (is_colored[vertex.idx()] == 0) {
          next.push_back(vertex);
        }
      }
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    colors.reserve(next.size());
    for (const Vertex vertex : next) {
      colors.push_back(ColorAround(*mesh, is_colored, vertex));
    }
    for (size_t i = 0; i < next.size(); ++i) {
      mesh->set_color(next[i], colors[i]);
      is_colored[next[i].idx()] = 1;
    }
    border = std::move(next);
  }
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
  std::vector<uint8_t> is_colored(colored.n_vertices());
  ParallelFor(
      context,
      colored.n_vertices(),
      kVertexGrain,
      [&](size_t begin, size_t end) {
        for (size_t v = begin; v < end; ++v) {
          const Vertex vertex{int(v)};
          const Eigen::Vector3f point =
              cube.ToUnit(colored.point(vertex)).cast<float>();
          const Eigen::Vector3f normal = colored.normal(vertex).cast<float>();
          const std::optional<Color> color = BlendColor(
              views, visibility.Select(point, normal), point, spacing);
          is_colored[v] = color.has_value();
          colored.set_color(
              vertex,
              color.value_or(Color(kUnseenGrey, kUnseenGrey, kUnseenGrey)));
        }
        phase.Advance(end - begin);
      });
  FillUncolored(std::move(is_colored), &colored);
  return colored;
}

}  // namespace octacut
