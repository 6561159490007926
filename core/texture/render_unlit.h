// Pictures of a mesh's own colours, without any light: what texturing is
// measured by.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/raycast/ray_scene.h"
#include "core/texture/photographs.h"
#include "core/texture/textured_mesh.h"

namespace octacut {

struct UnlitPicture {
  cv::Mat color;    // CV_8UC3, BGR; black where the mesh is not
  cv::Mat covered;  // CV_8UC1: 255 where the mesh covers the whole pixel
};

// 2 x 2 samples per pixel. `rays` are of the mesh.
UnlitPicture RenderTexture(const TexturedMesh& mesh,
                           const RayScene& rays,
                           const PhotographPose& pose,
                           const Context& context);
// Black where the mesh has no vertex colours.
UnlitPicture RenderVertexColors(const IndexedMesh& mesh,
                                const RayScene& rays,
                                const PhotographPose& pose,
                                const Context& context);

// The picture of a textured mesh in smooth shading, by its normal map where it
// has one: the texture as albedo under the lamps of RenderShaded, on white.
// CV_8UC3, BGR.
cv::Mat RenderRelit(const TexturedMesh& mesh,
                    const RayScene& rays,
                    const PhotographPose& pose,
                    const Context& context);

}  // namespace octacut
