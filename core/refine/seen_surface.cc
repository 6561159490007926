#include "core/refine/seen_surface.h"

#include <algorithm>
#include <utility>

#include "core/mesh/mean_edge.h"
#include "core/mesh/normals.h"

namespace octacut {
namespace {

// Rays begin this far before the surface, in edges of the mesh.
constexpr double kClearance = 1.5;
// At the views' own scale a view has to see what a patch covers and so many
// pixels more; rays from there begin closer to the surface, by edges of the
// mesh or pixels. In coarser rounds the surface is still too rough for that.
constexpr double kRingMargin = 2;
constexpr double kRingClearance = 0.4;
// A piece of the surface needs some triangles, however large they are.
constexpr double kMinFitEdges = 2.5;
// Pieces grow with the pixels of the round up to so many times; larger ones
// would level what coarse rounds must see.
constexpr double kMaxFitScale = 2.7;

LinesOfSight MakeLines(double edge, const Look& look) {
  const double patch_radius = look.options.patch.radius;
  LinesOfSight lines;
  lines.pixel = look.pixel * look.scale;
  lines.clearance = kClearance * edge;
  lines.patch_radius = patch_radius * look.scale * look.pixel;
  if (look.scale == 1) {
    lines.ring_radius = patch_radius + kRingMargin;
    lines.ring_clearance = kRingClearance * std::max(edge, look.pixel);
  }
  return lines;
}

// Of all points, or of those in the part.
std::vector<ChosenViews> ChooseViewsOf(const SeenSurface& seen,
                                       const Look& look,
                                       const Context& context) {
  const LinesOfSight lines = MakeLines(seen.edge, look);
  const auto choose = [&](const std::vector<LocalSurface>& surfaces) {
    return ChooseViews(
        look.views, seen.rays, surfaces, lines, look.options.views, context);
  };
  if (look.part.empty()) {
    return choose(seen.surfaces);
  }
  std::vector<size_t> points;
  std::vector<LocalSurface> surfaces;
  for (size_t i = 0; i < seen.surfaces.size(); ++i) {
    if (look.part[seen.points.vertices[i]]) {
      points.push_back(i);
      surfaces.push_back(seen.surfaces[i]);
    }
  }
  const std::vector<ChosenViews> choices = choose(surfaces);
  std::vector<ChosenViews> all(seen.surfaces.size());
  for (size_t k = 0; k < points.size(); ++k) {
    all[points[k]] = choices[k];
  }
  return all;
}

}  // namespace

double PixelSizeAt(const ViewSet& views, const IndexedMesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& position : mesh.positions) {
    sum += position;
  }
  return PixelSize(views, (sum / double(mesh.positions.size())).cast<float>());
}

size_t SeenSurface::NumSeen() const {
  return size_t(std::count(is_seen.begin(), is_seen.end(), 1));
}

SeenSurface LookAtSurface(const Look& look,
                          const Context& context,
                          IndexedMesh* mesh) {
  return LookAtPoints(
      SpreadPoints(*mesh, look.neighbors, look.spacing), look, context, mesh);
}

SeenSurface LookAtPoints(SurfacePoints points,
                         const Look& look,
                         const Context& context,
                         IndexedMesh* mesh) {
  mesh->normals = ComputeVertexNormals(*mesh, context);
  const double edge = MeanEdge(*mesh);
  const double fit_radius =
      look.options.fit_radius * look.pixel * std::min(look.scale, kMaxFitScale);
  std::vector<LocalSurface> surfaces =
      FitLocalSurfaces(*mesh,
                       look.neighbors,
                       points.vertices,
                       std::max(fit_radius, kMinFitEdges * edge),
                       context);
  SeenSurface seen{
      edge, std::move(points), std::move(surfaces), RayScene(*mesh), {}, {}};
  seen.choices = ChooseViewsOf(seen, look, context);
  for (const ChosenViews& chosen : seen.choices) {
    seen.is_seen.push_back(chosen.count >= 2);
  }
  return seen;
}

}  // namespace octacut
