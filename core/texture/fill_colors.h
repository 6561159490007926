// Colours for the parts of a mesh that no photograph shows.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/vertex_corners.h"
#include "core/texture/blend_weights.h"

namespace octacut {

// Colours (blue, green, red) of all vertices: the consensus where triangles
// around are seen, and elsewhere the smoothest continuation of it (harmonic
// over the mesh). Pieces of the mesh that no view shows get the mean colour.
std::vector<Eigen::Vector3f> FillColors(const IndexedMesh& mesh,
                                        const VertexCorners& vertex_faces,
                                        const FaceChoice& chosen,
                                        const Context& context);

}  // namespace octacut
