#include "core/refine/local_surface.h"

#include <gtest/gtest.h>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::Random;

IndexedMesh WithNormals(IndexedMesh mesh) {
  mesh.normals = ComputeVertexNormals(mesh, Context(1));
  return mesh;
}

TEST(LocalSurface, FindsCurvatureAndNormalOfASphere) {
  const double radius = 0.4;
  const IndexedMesh mesh = WithNormals(Sphere(40, radius));
  const std::vector<LocalSurface> surfaces =
      FitLocalSurfaces(mesh,
                       testing::RefineScene::Neighbors(mesh),
                       testing::AllVertices(mesh),
                       0.06,
                       Context(2));
  ASSERT_EQ(surfaces.size(), mesh.positions.size());
  for (size_t v = 0; v < surfaces.size(); ++v) {
    const LocalSurface& surface = surfaces[v];
    const Eigen::Vector3f outward = mesh.positions[v].cast<float>() / radius;
    EXPECT_GT(surface.normal.dot(outward), 0.9999);
    EXPECT_NEAR(surface.normal.dot(surface.tangent_u), 0, 1e-5);
    EXPECT_NEAR(surface.uu, -0.5 / radius, 0.1);
    EXPECT_NEAR(surface.vv, -0.5 / radius, 0.1);
    EXPECT_NEAR(surface.uv, 0, 0.1);
    EXPECT_NEAR(surface.height, 0, 2e-4);
  }
}

// With some 30 vertices per radius, samples stand for several of them.
TEST(LocalSurface, OfAFineMeshIsThatOfTheSphere) {
  const double radius = 0.4;
  const double window = 0.16;
  const IndexedMesh mesh = WithNormals(Sphere(120, radius));
  const std::vector<LocalSurface> surfaces =
      FitLocalSurfaces(mesh,
                       testing::RefineScene::Neighbors(mesh),
                       {0, 1000, 40000, 86000},
                       window,
                       Context(2));
  const IndexedMesh coarse_mesh = WithNormals(Sphere(30, radius));
  const LocalSurface coarse =
      FitLocalSurfaces(coarse_mesh,
                       testing::RefineScene::Neighbors(coarse_mesh),
                       {2000},
                       window,
                       Context(2))
          .front();
  for (const LocalSurface& surface : surfaces) {
    EXPECT_NEAR(surface.center.norm(), coarse.center.norm(), 2e-4);
    EXPECT_NEAR(surface.uu, coarse.uu, 0.02);
    EXPECT_NEAR(surface.vv, coarse.vv, 0.02);
    EXPECT_GT(surface.normal.dot(surface.center.normalized()), 0.9999);
  }
}

TEST(LocalSurface, LooksThroughNoise) {
  Random random(1);
  const double noise = 0.004;
  const IndexedMesh mesh =
      WithNormals(Sphere(40, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        return (0.4 + random.Uniform(-noise, noise)) * p;
      }));
  const std::vector<LocalSurface> surfaces =
      FitLocalSurfaces(mesh,
                       testing::RefineScene::Neighbors(mesh),
                       testing::AllVertices(mesh),
                       0.08,
                       Context(2));
  double before = 0, after = 0;
  for (size_t v = 0; v < surfaces.size(); ++v) {
    before += std::abs(mesh.positions[v].norm() - 0.4);
    after += std::abs(double(surfaces[v].center.norm()) - 0.4);
    // The center is where the height says, next to the vertex.
    EXPECT_NEAR((surfaces[v].center - mesh.positions[v].cast<float>())
                    .dot(surfaces[v].normal),
                surfaces[v].height,
                1e-6);
  }
  EXPECT_LT(after, before / 3);
}

TEST(LocalSurface, IsFittedWhereAskedFor) {
  const IndexedMesh mesh = WithNormals(Sphere(10, 1));
  const VertexCorners neighbors = testing::RefineScene::Neighbors(mesh);
  const std::vector<LocalSurface> all = FitLocalSurfaces(
      mesh, neighbors, testing::AllVertices(mesh), 0.3, Context(1));
  const std::vector<uint32_t> some = {3, 50, 51};
  const std::vector<LocalSurface> surfaces =
      FitLocalSurfaces(mesh, neighbors, some, 0.3, Context(2));
  ASSERT_EQ(surfaces.size(), some.size());
  for (size_t i = 0; i < some.size(); ++i) {
    EXPECT_EQ(surfaces[i].center, all[some[i]].center);
    EXPECT_EQ(surfaces[i].uu, all[some[i]].uu);
  }
}

TEST(LocalSurface, HasTheNormalOfItsQuadric) {
  LocalSurface surface;
  surface.normal = Eigen::Vector3f(1, 2, -2) / 3;
  surface.tangent_u = Eigen::Vector3f(2, 1, 2) / 3;
  surface.uu = 0.4f;
  surface.uv = -0.7f;
  surface.vv = 0.2f;
  const auto point = [&](float x, float y) -> Eigen::Vector3f {
    return x * surface.tangent_u + y * surface.TangentV() +
           surface.Height(x, y) * surface.normal;
  };
  const float step = 1e-2f;
  for (const auto& [x, y] : {std::pair(0.0f, 0.0f), std::pair(0.8f, -0.3f)}) {
    const Eigen::Vector3f normal = surface.NormalAt(x, y);
    EXPECT_NEAR(normal.dot(point(x + step, y) - point(x - step, y)), 0, 1e-6);
    EXPECT_NEAR(normal.dot(point(x, y + step) - point(x, y - step)), 0, 1e-6);
    EXPECT_GT(normal.dot(surface.normal), 0);
  }
}

TEST(LocalSurface, IsThePlaneOfAVertexWithFewNeighbors) {
  const IndexedMesh mesh = WithNormals(Cube(1));
  const std::vector<LocalSurface> surfaces =
      FitLocalSurfaces(mesh,
                       testing::RefineScene::Neighbors(mesh),
                       testing::AllVertices(mesh),
                       0.1,
                       Context(1));
  for (size_t v = 0; v < surfaces.size(); ++v) {
    EXPECT_EQ(surfaces[v].center, mesh.positions[v].cast<float>());
    EXPECT_LT((surfaces[v].normal - mesh.normals[v]).norm(), 1e-6);
    EXPECT_EQ(surfaces[v].Height(1, 1), 0);
  }
}

}  // namespace
}  // namespace octacut
