#include "core/texture/held_out_scores.h"

#include <opencv2/core.hpp>

#include "core/raycast/ray_scene.h"
#include "core/texture/render_unlit.h"

namespace octacut {

HeldOutScores ScoreHeldOut(const TexturedMesh& textured,
                           const std::vector<IndexedMesh>& colored,
                           const Photographs& held_out,
                           const Context& context) {
  Phase phase(context, "scores", held_out.poses.size());
  const RayScene rays(textured.mesh);
  std::vector<RayScene> rays_of_colored;
  rays_of_colored.reserve(colored.size());
  for (const IndexedMesh& mesh : colored) {
    rays_of_colored.emplace_back(mesh);
  }
  HeldOutScores scores;
  scores.meshes.resize(1 + colored.size());
  for (size_t v = 0; v < held_out.poses.size(); ++v) {
    const PhotographPose& pose = held_out.poses[v];
    const Photograph photograph = held_out.load(v);
    std::vector<UnlitPicture> pictures = {
        RenderTexture(textured, rays, pose, context)};
    for (size_t i = 0; i < colored.size(); ++i) {
      pictures.push_back(
          RenderVertexColors(colored[i], rays_of_colored[i], pose, context));
    }
    cv::Mat region = photograph.mask == 255;
    for (const UnlitPicture& picture : pictures) {
      region &= picture.covered;
    }
    for (size_t i = 0; i < pictures.size(); ++i) {
      AddScores(pictures[i].color, photograph.image, region, &scores.meshes[i]);
    }
    AddNoise(photograph.image, region, &scores.noise);
    phase.Advance();
  }
  return scores;
}

}  // namespace octacut
