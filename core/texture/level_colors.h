// Corrections of colour that make photographs fit together on the surface.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/vertex_corners.h"
#include "core/texture/blend_weights.h"

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
                                         const VertexCorners& vertex_faces,
                                         const FaceChoice& chosen,
                                         const VertexViews& vertex_views,
                                         const Context& context);

}  // namespace octacut
