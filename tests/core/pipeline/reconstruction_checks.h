// Runs on synthetic scenes and questions to their meshes, for the tests of
// this folder.
#pragma once

#include <string>
#include <utility>

#include "core/pipeline/reconstruct.h"
#include "core/raycast/ray_scene.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"

namespace octacut::testing {

struct ReconstructedScene {
  SyntheticScene synthetic;
  Scene scene;
  Region region;
  ReconstructionOptions options;
  Reconstruction result;
  IndexedMesh mesh;  // of `result`

  double VoxelSize() const {
    return region.cube.VoxelSize(options.target_level);
  }
};

// 32^3 to 64^3.
inline ReconstructionOptions QuickOptions() {
  ReconstructionOptions options;
  options.hull.hull_level = 5;
  options.target_level = 6;
  return options;
}

inline SceneSpec PipelineSpec(const std::string& object,
                              int width = 160,
                              int height = 120) {
  SceneSpec spec = QuickScene(object, width, height, 24);
  spec.lighting.num_samples = 4;
  return spec;
}

inline ReconstructedScene ReconstructScene(SyntheticScene synthetic,
                                           const ReconstructionOptions& options,
                                           const RegionOptions& region = {}) {
  const Context context(2);
  ReconstructedScene scene;
  scene.options = options;
  scene.synthetic = std::move(synthetic);
  scene.scene = ToScene(scene.synthetic);
  scene.region =
      EstimateRegion(scene.scene.views, scene.scene.points, region, context);
  scene.result = Reconstruct(scene.scene, scene.region, options, context);
  scene.mesh = ToIndexedMesh(scene.result.mesh);
  return scene;
}

inline ReconstructedScene ReconstructScene(
    const SceneSpec& spec, const ReconstructionOptions& options) {
  return ReconstructScene(MakeScene(spec, Context(2)), options);
}

// Whether a point is inside a closed mesh: the first triangle that a ray meets
// is seen from behind. Of three rays the majority, as one may graze an edge.
class InsideTest {
 public:
  explicit InsideTest(const IndexedMesh& mesh) : mesh_(mesh), rays_(mesh) {}

  bool operator()(const Eigen::Vector3d& point) const {
    int votes = 0;
    for (const Eigen::Vector3d& direction :
         {Eigen::Vector3d(0.36, 0.48, 0.8),
          Eigen::Vector3d(-0.61, 0.52, -0.6),
          Eigen::Vector3d(0.2, -0.87, 0.45)}) {
      const auto hit = rays_.FirstHit(point, direction);
      votes += hit && Normal(hit->triangle).dot(direction) > 0;
    }
    return votes >= 2;
  }

 private:
  Eigen::Vector3d Normal(uint32_t triangle) const {
    const auto& corners = mesh_.triangles[triangle];
    const Eigen::Vector3d& a = mesh_.positions[corners[0]];
    return (mesh_.positions[corners[1]] - a)
        .cross(mesh_.positions[corners[2]] - a);
  }

  const IndexedMesh& mesh_;
  RayScene rays_;
};

// Mean distance of the vertices of `mesh` to the surface of `reference`.
inline double MeanDistance(const IndexedMesh& mesh,
                           const IndexedMesh& reference) {
  const RayScene rays(reference);
  double sum = 0;
  for (const Eigen::Vector3d& position : mesh.positions) {
    sum += rays.ClosestPoint(position).distance;
  }
  return sum / double(mesh.positions.size());
}

}  // namespace octacut::testing
