// A textured sphere, photographs of it, and meshes near it, for the tests of
// this folder.
#pragma once

#include <cmath>
#include <numeric>
#include <vector>

#include "core/benchmark/synthetic/noise.h"
#include "core/mesh/normals.h"
#include "core/mesh/vertex_corners.h"
#include "tests/core/mesh/test_shapes.h"
#include "tests/core/views/test_scene.h"

namespace octacut::testing {

inline std::vector<uint32_t> AllVertices(const IndexedMesh& mesh) {
  std::vector<uint32_t> vertices(mesh.positions.size());
  std::iota(vertices.begin(), vertices.end(), 0u);
  return vertices;
}

struct RefineScene {
  static constexpr double kRadius = 0.8;  // world units, around the origin
  TestScene test;

  double Pixel() const { return test.PixelSize(); }
  // A sphere of 6 n^2 squares whose vertices are moved outward by
  // height(direction), world units.
  template <typename Height>
  static IndexedMesh Mesh(uint32_t n, const Height& height) {
    return Sphere(n, [&](const Eigen::Vector3d& direction) -> Eigen::Vector3d {
      return (kRadius + height(direction)) * direction;
    });
  }
  // The same as steps within unit coordinates want it, with normals.
  IndexedMesh ToUnitMesh(IndexedMesh mesh) const {
    for (Eigen::Vector3d& position : mesh.positions) {
      position = ToUnit(test.region.cube, position);
    }
    mesh.normals = ComputeVertexNormals(mesh, Context(2));
    return mesh;
  }
  // A sphere that is so many pixels larger than the object.
  IndexedMesh Larger(uint32_t n, double pixels) const {
    return ToUnitMesh(Mesh(n, [&](const auto&) { return pixels * Pixel(); }));
  }
  static VertexCorners Neighbors(const IndexedMesh& mesh) {
    return FindVertexNeighbors(mesh.positions.size(), mesh.triangles);
  }
  static double MeanError(const IndexedMesh& mesh) {
    double sum = 0;
    for (const Eigen::Vector3d& position : mesh.positions) {
      sum += std::abs(position.norm() - kRadius);
    }
    return sum / double(mesh.positions.size());
  }
};

inline SceneSpec RefineSceneSpec() {
  SceneSpec spec = TestSpec("sphere", 192, 144, 28);
  spec.rig.min_elevation = -60;
  spec.texture.kind = TextureKind::kSpeckle;
  spec.texture.scale = 0.18;
  spec.reference.resolution = 64;
  return spec;
}

// `min_elevation` of the cameras, degrees: from 10 on nobody sees the bottom.
// `pixel_noise` of the photographs: grey levels.
inline RefineScene MakeRefineScene(double min_elevation = -60,
                                   double pixel_noise = 0) {
  return {MakeTestScene(RenderOnce(std::pair(min_elevation, pixel_noise),
                                   [](const auto& elevation_and_noise) {
                                     SceneSpec spec = RefineSceneSpec();
                                     std::tie(spec.rig.min_elevation,
                                              spec.degrade.pixel_noise) =
                                         elevation_and_noise;
                                     return spec;
                                   }))};
}

// The same with masks that are `mask_offset` pixels too large.
inline RefineScene MakeSceneWithMasksOff(int mask_offset) {
  return {MakeTestScene(RenderOnce(mask_offset, [](int offset) {
    SceneSpec spec = RefineSceneSpec();
    spec.degrade.mask_offset = offset;
    return spec;
  }))};
}

// The same with poses that are so many pixels off.
inline RefineScene MakeSceneWithPosesOff(double pixels) {
  SceneSpec spec = RefineSceneSpec();
  spec.degrade.pose_noise = pixels;
  return {MakeTestScene(spec)};
}

// The same of polished metal, in photographs with noise.
inline RefineScene MakeMetalScene() {
  SceneSpec spec = RefineSceneSpec();
  spec.material = MaterialKind::kMetal;
  spec.degrade.pixel_noise = 1;
  return {MakeTestScene(spec)};
}

// Bumps of up to `amplitude` some 0.16 units wide, as a mesh of voxels has
// them after smoothing.
inline auto Bumps(double amplitude) {
  return [amplitude](const Eigen::Vector3d& direction) {
    return amplitude *
           FractalNoise(
               5 * RefineScene::kRadius * direction.cast<float>(), 1, 3);
  };
}

}  // namespace octacut::testing
