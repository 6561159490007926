#include "core/refine/narrow_rounds.h"

#include <gtest/gtest.h>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::RefineScene;

// Runs the rounds on the scene's sphere with `height` (world units), which they
// start from, after one in which `num_measured` of 100 points had an offset.
// Returns the summaries of the rounds.
template <typename Height>
std::vector<RoundSummary> RunOn(RefineScene* scene,
                                const Height& height,
                                IndexedMesh* mesh,
                                size_t num_measured = 100) {
  *mesh = scene->ToUnitMesh(RefineScene::Mesh(40, height));
  const std::vector<Eigen::Vector3d> start = mesh->positions;
  const VertexCorners neighbors = RefineScene::Neighbors(*mesh);
  const RefineOptions options;
  const double pixel = scene->Pixel() / scene->test.region.cube.edge;
  std::vector<RoundSummary> rounds(1);
  rounds[0].num_seen = 100;
  rounds[0].num_measured = num_measured;
  RefineNarrowParts({start, neighbors, pixel, options},
                    {.range = RefineOptions::kRange},
                    Context(2),
                    &scene->test.views,
                    mesh,
                    &rounds);
  rounds.erase(rounds.begin());
  return rounds;
}

// Of a mesh in unit coordinates, pixels.
double MeanErrorInPixels(const RefineScene& scene, IndexedMesh mesh) {
  for (Eigen::Vector3d& position : mesh.positions) {
    position = testing::ToWorld(scene.test.region.cube, position);
  }
  return RefineScene::MeanError(mesh) / scene.Pixel();
}

TEST(RefineNarrowParts, GoesOnWhileMuchOfTheSurfaceGains) {
  RefineScene scene = testing::MakeRefineScene();
  const auto wrong = testing::Bumps(4 * scene.Pixel());
  const double before =
      MeanErrorInPixels(scene, scene.ToUnitMesh(RefineScene::Mesh(40, wrong)));
  IndexedMesh mesh;
  const std::vector<RoundSummary> rounds = RunOn(&scene, wrong, &mesh);
  EXPECT_GT(before, 0.5);
  EXPECT_LT(MeanErrorInPixels(scene, mesh), 0.3 * before);
  ASSERT_GE(rounds.size(), 3u);
  EXPECT_LT(rounds[0].taken_back, 0.5);
  EXPECT_EQ(rounds[0].range, 3);
  EXPECT_EQ(rounds[1].range, 6);
}

TEST(RefineNarrowParts, LooksAgainOnlyAroundWhatHasGained) {
  RefineScene scene = testing::MakeRefineScene();
  const auto bumps = testing::Bumps(4 * scene.Pixel());
  const auto wrong_on_one_side = [&](const Eigen::Vector3d& direction) {
    return direction.x() > 0.5 ? bumps(direction) : 0.0;
  };
  IndexedMesh mesh;
  const std::vector<RoundSummary> rounds =
      RunOn(&scene, wrong_on_one_side, &mesh);
  EXPECT_LT(MeanErrorInPixels(scene, mesh), 0.1);
  ASSERT_GE(rounds.size(), 3u);
  EXPECT_LT(rounds[1].num_seen, 0.7 * double(rounds[0].num_seen));
  EXPECT_GT(rounds[1].num_seen, 0.2 * double(rounds[0].num_seen));
}

TEST(RefineNarrowParts, StopsWhereNothingIsGained) {
  RefineScene scene = testing::MakeRefineScene(-60, 200);
  const auto right = [](const auto&) { return 0.0; };
  IndexedMesh mesh;
  const std::vector<RoundSummary> rounds = RunOn(&scene, right, &mesh);
  EXPECT_EQ(rounds.size(), 1u);
  EXPECT_GT(rounds[0].taken_back, 0.9);
  EXPECT_LT(MeanErrorInPixels(scene, mesh), 0.1);
}

TEST(RefineNarrowParts, DoesNotBeginWhereHardlyAnyPointHasAnOffset) {
  RefineScene scene = testing::MakeRefineScene();
  const auto wrong = testing::Bumps(4 * scene.Pixel());
  IndexedMesh mesh;
  EXPECT_TRUE(RunOn(&scene, wrong, &mesh, 9).empty());
  EXPECT_EQ(mesh.positions,
            scene.ToUnitMesh(RefineScene::Mesh(40, wrong)).positions);
}

}  // namespace
}  // namespace octacut
