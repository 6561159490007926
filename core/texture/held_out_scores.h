// Compares pictures of meshes with photographs that were left out of texturing.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/texture/image_scores.h"
#include "core/texture/photographs.h"
#include "core/texture/textured_mesh.h"

namespace octacut {

struct HeldOutScores {
  std::vector<ImageScores> meshes;
  ImageScores noise;  // AddNoise of the photographs: about the limit
};

// Scores of the textured mesh, then those of each mesh of `colored` with its
// vertex colours, over the pixels of all `held_out` photographs that are in the
// masks and that all of the meshes cover.
HeldOutScores ScoreHeldOut(const TexturedMesh& textured,
                           const std::vector<IndexedMesh>& colored,
                           const Photographs& held_out,
                           const Context& context);

}  // namespace octacut
