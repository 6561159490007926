// A mesh as foreign files have it: polygons with any number of corners, open
// or not manifold, perhaps only points.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct PolygonMesh {
  std::vector<Eigen::Vector3d> positions;
  // Values of the vertices; both empty or as many as `positions`.
  std::vector<Eigen::Vector3f> normals;
  std::vector<std::array<uint8_t, 3>> colors;
  std::vector<float> confidence;  // likewise
  // Face i has the corners [face_begins[i], face_begins[i + 1]).
  std::vector<uint64_t> face_begins = {0};
  std::vector<uint32_t> corners;

  size_t NumFaces() const { return face_begins.size() - 1; }
  std::span<const uint32_t> Face(size_t face) const {
    return std::span(corners).subspan(
        face_begins[face], face_begins[face + 1] - face_begins[face]);
  }
  void EndFace() { face_begins.push_back(corners.size()); }
};

// Removes the vertices with coordinates that are not finite, as COLMAP's
// poisson_mesher writes some, and the faces at them; says so in `notes`. Throws
// InputError "<name>: ..." if no vertex is left, and, before faces are
// renumbered, for a corner that is no vertex, as Triangulate does.
void RemoveNonFinite(const std::string& name,
                     PolygonMesh* mesh,
                     std::vector<std::string>* notes);

// Triangles of all faces, in their order. A quadrilateral is cut along its
// shorter inner diagonal, a larger polygon by clipping the ears of its
// projection along its (Newell) normal, a polygon of very many corners as a
// fan. Faces of fewer than three corners are left out; what was changed is
// said in `notes`. Triangles that name a vertex twice are kept: an audit
// should see them. Throws InputError "<name>: face ..." for a corner that is
// no vertex; faces are counted from 0.
IndexedMesh Triangulate(PolygonMesh mesh,
                        const std::string& name,
                        std::vector<std::string>* notes);

// Colours of 8 bits per channel. Values are out of `full_scale`; 0 means that
// nothing is known: out of 1 if none is larger, otherwise out of 255.
std::vector<std::array<uint8_t, 3>> QuantizeColors(
    std::span<const Eigen::Vector3f> colors, float full_scale);

}  // namespace octacut
