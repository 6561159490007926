// Normal maps: the detail of a full mesh in the texture of a simplified one.
#pragma once

#include <cstddef>
#include <Eigen/Core>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/raycast/ray_scene.h"
#include "core/texture/atlas_layout.h"
#include "core/texture/textured_mesh.h"

namespace octacut {

struct NormalMapSummary {
  size_t num_texels = 0;  // within triangles
  // Those without a point of the full mesh near enough: they get the normal of
  // the simplified mesh.
  size_t num_missed = 0;
  double max_distance = 0;  // how near it must be, in units of the mesh
  // Mean angle between the normals of both meshes, degrees.
  double mean_angle = 0;
};

// Adds `tangents` and the `normals` of all pages to `textured`, whose layout is
// `layout`. Each texel gets the normal of the nearest point of `full` along the
// interpolated normal, outward or inward, whose surface faces the same way.
//
// Normals are stored in the frame of tangent, bitangent and normal as glTF 2.0
// has it: tangents point along u and are orthogonal to the normals of vertices,
// the bitangent is cross(normal, tangent) times the tangent's fourth component
// and points up in the page; all three are interpolated linearly and then made
// unit vectors.
//
// Throws InputError for a full mesh without triangles, and where more than half
// of the texels are missed: the meshes are then not of the same surface. The
// same bytes for any number of threads.
NormalMapSummary BakeNormals(const IndexedMesh& full,
                             const AtlasLayout& layout,
                             const Context& context,
                             TexturedMesh* textured);

// The normal that the map of `mesh` gives a point of its surface, a unit vector
// in the frame of the mesh.
Eigen::Vector3f MappedNormal(const TexturedMesh& mesh,
                             const RayScene::Hit& hit);

}  // namespace octacut
