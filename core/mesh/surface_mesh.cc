#include "core/mesh/surface_mesh.h"

#include <fmt/format.h>

#include "core/base/error.h"

template class OpenMesh::PropertyT<octacut::SurfaceMesh::Point>;
template class OpenMesh::PropertyT<octacut::SurfaceMesh::Color>;

namespace octacut {
namespace {

// OpenMesh can accept triangles that leave a vertex with two fans; it then
// sees only one of them, so counting incident triangles shows it.
void CheckFans(const SurfaceMesh& mesh, const IndexedMesh& from) {
  std::vector<uint32_t> counts(from.positions.size(), 0);
  for (const std::array<uint32_t, 3>& triangle : from.triangles) {
    for (const uint32_t vertex : triangle) {
      ++counts[vertex];
    }
  }
  for (const auto vertex : mesh.vertices()) {
    uint32_t seen = 0;
    for (auto face = mesh.cvf_iter(vertex); face.is_valid(); ++face) {
      ++seen;
    }
    if (seen != counts[vertex.idx()]) {
      throw InvariantError(fmt::format(
          "vertex {} has more than one fan of triangles", vertex.idx()));
    }
  }
}

}  // namespace

SurfaceMesh ToSurfaceMesh(const IndexedMesh& mesh) {
  SurfaceMesh result;
  const bool has_normals = !mesh.normals.empty();
  const bool has_colors = !mesh.colors.empty();
  if (has_normals) {
    result.request_vertex_normals();
  }
  if (has_colors) {
    result.request_vertex_colors();
  }
  const size_t num_triangles = mesh.triangles.size();
  result.reserve(
      mesh.positions.size(), num_triangles + num_triangles / 2, num_triangles);
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto vertex = result.add_vertex(mesh.positions[v]);
    if (has_normals) {
      result.set_normal(vertex, mesh.normals[v].cast<double>());
    }
    if (has_colors) {
      const std::array<uint8_t, 3>& c = mesh.colors[v];
      result.set_color(vertex, {c[0], c[1], c[2]});
    }
  }
  for (size_t t = 0; t < num_triangles; ++t) {
    const std::array<uint32_t, 3>& triangle = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) {
      if (triangle[i] >= mesh.positions.size() ||
          triangle[i] == triangle[(i + 1) % 3]) {
        throw InvariantError(fmt::format("triangle {} ({}, {}, {}) is invalid",
                                         t,
                                         triangle[0],
                                         triangle[1],
                                         triangle[2]));
      }
    }
    if (!result
             .add_face(SurfaceMesh::VertexHandle(int(triangle[0])),
                       SurfaceMesh::VertexHandle(int(triangle[1])),
                       SurfaceMesh::VertexHandle(int(triangle[2])))
             .is_valid()) {
      throw InvariantError(
          fmt::format("triangle {} ({}, {}, {}) meets a complex edge or vertex",
                      t,
                      triangle[0],
                      triangle[1],
                      triangle[2]));
    }
  }
  CheckFans(result, mesh);
  return result;
}

IndexedMesh ToIndexedMesh(const SurfaceMesh& mesh) {
  IndexedMesh result;
  const size_t num_vertices = mesh.n_vertices();
  result.positions.assign(mesh.points(), mesh.points() + num_vertices);
  if (mesh.has_vertex_normals()) {
    result.normals.reserve(num_vertices);
    for (const auto vertex : mesh.vertices()) {
      result.normals.push_back(mesh.normal(vertex).cast<float>());
    }
  }
  if (mesh.has_vertex_colors()) {
    result.colors.reserve(num_vertices);
    for (const auto vertex : mesh.vertices()) {
      const OpenMesh::Vec3uc& c = mesh.color(vertex);
      result.colors.push_back({c[0], c[1], c[2]});
    }
  }
  result.triangles.reserve(mesh.n_faces());
  for (const auto face : mesh.faces()) {
    // The half-edge of a face leads to its first corner.
    auto edge = mesh.halfedge_handle(face);
    std::array<uint32_t, 3>& triangle = result.triangles.emplace_back();
    for (uint32_t& corner : triangle) {
      corner = uint32_t(mesh.to_vertex_handle(edge).idx());
      edge = mesh.next_halfedge_handle(edge);
    }
  }
  return result;
}

}  // namespace octacut
