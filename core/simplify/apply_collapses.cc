#include "core/simplify/apply_collapses.h"

#include <numeric>
#include <utility>

#include "core/simplify/collapse_rules.h"

namespace octacut {
namespace {

constexpr uint32_t kGone = 0xffffffffu;

SurfaceMesh BareSurface(const IndexedMesh& full) {
  IndexedMesh bare;
  bare.positions = full.positions;
  bare.triangles = full.triangles;
  SurfaceMesh surface = ToSurfaceMesh(bare);
  surface.request_vertex_status();
  surface.request_edge_status();
  surface.request_halfedge_status();
  surface.request_face_status();
  return surface;
}

// Returns whether the collapse was made. `is_known_good`: all that were found
// before were made, so that it is allowed, too.
bool Apply(const Collapse& collapse, bool is_known_good, SurfaceMesh* surface) {
  const auto from = SurfaceMesh::VertexHandle{int(collapse.from)};
  const auto to = SurfaceMesh::VertexHandle{int(collapse.to)};
  if (surface->status(from).deleted() || surface->status(to).deleted()) {
    return false;
  }
  const auto edge = surface->find_halfedge(from, to);
  if (!edge.is_valid() ||
      (!is_known_good && (!KeepsManifold(*surface, edge) ||
                          !KeepsTriangleShapes(*surface, edge)))) {
    return false;
  }
  surface->collapse(edge);
  return true;
}

// The vertices that are left, in their order, and their new numbers.
std::vector<uint32_t> KeepVertices(const SurfaceMesh& surface,
                                   const IndexedMesh& full,
                                   IndexedMesh* mesh) {
  std::vector<uint32_t> numbers(full.positions.size(), kGone);
  for (uint32_t v = 0; v < numbers.size(); ++v) {
    if (surface.status(SurfaceMesh::VertexHandle(int(v))).deleted()) {
      continue;
    }
    numbers[v] = uint32_t(mesh->positions.size());
    mesh->positions.push_back(full.positions[v]);
    if (!full.colors.empty()) {
      mesh->colors.push_back(full.colors[v]);
    }
    if (!full.confidence.empty()) {
      mesh->confidence.push_back(full.confidence[v]);
    }
  }
  return numbers;
}

}  // namespace

CollapseReplay::CollapseReplay(const IndexedMesh& full,
                               size_t num_triangles,
                               const Context& context)
    : full_(full),
      surface_(BareSurface(full)),
      collapses_(FindCollapses(surface_, num_triangles, context)) {}

size_t CollapseReplay::LeastTriangles() const {
  return full_.triangles.size() - 2 * collapses_.size();
}

CollapsedMesh CollapseReplay::Run(size_t num_triangles,
                                  const std::vector<uint8_t>& held) const {
  SurfaceMesh surface = surface_;
  std::vector<uint32_t> targets(full_.positions.size());
  std::iota(targets.begin(), targets.end(), 0u);
  std::vector<uint32_t> moved_at(full_.positions.size(), 0);
  size_t num_left = full_.triangles.size();
  uint32_t number = 0;
  for (const Collapse& collapse : collapses_) {
    ++number;
    if (num_left <= num_triangles) {
      break;
    }
    if ((held.empty() || held[collapse.from] == 0) &&
        Apply(collapse, held.empty(), &surface)) {
      targets[collapse.from] = collapse.to;
      moved_at[collapse.from] = number;
      num_left -= 2;
    }
  }
  CollapsedMesh result;
  result.moved_at = std::move(moved_at);
  const std::vector<uint32_t> numbers =
      KeepVertices(surface, full_, &result.mesh);
  for (uint32_t t = 0; t < full_.triangles.size(); ++t) {
    const auto face = SurfaceMesh::FaceHandle{int(t)};
    if (surface.status(face).deleted()) {
      continue;
    }
    auto edge = surface.halfedge_handle(face);
    std::array<uint32_t, 3>& triangle = result.mesh.triangles.emplace_back();
    for (uint32_t& corner : triangle) {
      corner = numbers[size_t(surface.to_vertex_handle(edge).idx())];
      edge = surface.next_halfedge_handle(edge);
    }
    result.source_triangles.push_back(t);
  }
  result.owners.resize(targets.size());
  for (uint32_t v = 0; v < targets.size(); ++v) {
    uint32_t target = v;
    while (targets[target] != target) {
      target = targets[target] = targets[targets[target]];
    }
    result.owners[v] = numbers[target];
  }
  return result;
}

}  // namespace octacut
