// Corrections of colour that make photographs fit together on the surface.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/texture/blend_weights.h"
#include "core/texture/face_neighbors.h"

namespace octacut {

// For each entry of `vertex_views` what to add to its photograph's colour
// (blue, green, red levels) at its vertex; linear between vertices.
//
// The corrections g minimize, over the surface measured in pixels,
//     sum (g - (consensus - colour))^2 + kDetail^2 |gradient of g|^2
//   + kSeam (difference of the corrected colours of two photographs)^2
// where two photographs meet at a vertex: the seam and smoothness terms of V.
// Lempitsky and D. Ivanov ("Seamless Mosaicing of Image-Based Texture Maps",
// CVPR 2007), and a pull toward the median of all views. Below kDetail pixels
// the detail of the chosen photograph stays; what changes more slowly (shading
// that moves with the camera, vignetting, exposure) becomes that of all views.
std::vector<Eigen::Vector3f> LevelColors(const IndexedMesh& mesh,
                                         const VertexFaces& vertex_faces,
                                         const FaceChoice& chosen,
                                         const VertexViews& vertex_views,
                                         const Context& context);

// Colours (blue, green, red) of all vertices: the consensus where triangles
// around are seen, and elsewhere the smoothest continuation of it (harmonic
// over the mesh). Pieces of the mesh that no view shows get the mean colour.
std::vector<Eigen::Vector3f> FillColors(const IndexedMesh& mesh,
                                        const VertexFaces& vertex_faces,
                                        const FaceChoice& chosen,
                                        const Context& context);

}  // namespace octacut
