#include "core/refine/agreement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::RefineScene;

// The scene's sphere, whose halves with x < 0 and x > 0 are so many pixels too
// large, with a soft step between them.
IndexedMesh UnevenSphere(const RefineScene& scene, double left, double right) {
  return scene.ToUnitMesh(
      RefineScene::Mesh(40, [&](const Eigen::Vector3d& direction) {
        const double share = std::clamp(5 * direction.x() + 0.5, 0.0, 1.0);
        return (left + share * (right - left)) * scene.Pixel();
      }));
}

// The shares of the moves from `before` to `after` that `rule` (TakeBackHarm or
// KeepGains) takes back on the two halves, far from the step.
std::array<double, 2> TakeBack(const RefineScene& scene,
                               IndexedMesh before,
                               const IndexedMesh& after,
                               const decltype(TakeBackHarm)& rule) {
  const Context context(2);
  const VertexCorners neighbors = RefineScene::Neighbors(before);
  const RefineOptions options;
  const BoundingCube& cube = scene.test.region.cube;
  const double pixel = scene.Pixel() / cube.edge;
  const Look look{scene.test.views, neighbors, options, pixel};
  const SurfaceAgreement agreement = MeasureAgreement(look, context, &before);
  IndexedMesh mesh = after;
  rule(look, before.positions, agreement, context, &mesh);
  std::array<double, 2> way = {0, 0};
  std::array<double, 2> taken = {0, 0};
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    const double x =
        before.positions[v].x() - testing::ToUnit(cube, {0, 0, 0}).x();
    if (std::abs(x) * cube.edge > 0.3 * RefineScene::kRadius) {
      way[x > 0] += (after.positions[v] - before.positions[v]).norm();
      taken[x > 0] += (after.positions[v] - mesh.positions[v]).norm();
    }
  }
  return {taken[0] / way[0], taken[1] / way[1]};
}

TEST(TakeBackHarm, TakesBackWhatLeavesTheSurfaceAndNothingElse) {
  const RefineScene scene = testing::MakeRefineScene();
  const auto [left, right] = TakeBack(scene,
                                      UnevenSphere(scene, -2, 0),
                                      UnevenSphere(scene, 0, 2),
                                      TakeBackHarm);
  EXPECT_LT(left, 0.02);
  EXPECT_GT(right, 0.9);
}

TEST(TakeBackHarm, KeepsMovesWherePhotographsAreNoise) {
  const RefineScene scene = testing::MakeRefineScene(-60, 200);
  const auto [left, right] = TakeBack(scene,
                                      UnevenSphere(scene, 0, 0),
                                      UnevenSphere(scene, 2, 2),
                                      TakeBackHarm);
  EXPECT_LT(left, 0.15);
  EXPECT_LT(right, 0.15);
}

TEST(KeepGains, KeepsWhatReachesTheSurfaceAndNothingElse) {
  const RefineScene scene = testing::MakeRefineScene();
  const auto [left, right] = TakeBack(
      scene, UnevenSphere(scene, -2, 0), UnevenSphere(scene, 0, 2), KeepGains);
  EXPECT_LT(left, 0.1);
  EXPECT_GT(right, 0.98);
}

TEST(KeepGains, TakesBackWherePhotographsAreNoise) {
  const RefineScene scene = testing::MakeRefineScene(-60, 200);
  const auto [left, right] = TakeBack(
      scene, UnevenSphere(scene, 0, 0), UnevenSphere(scene, 2, 2), KeepGains);
  EXPECT_GT(left, 0.85);
  EXPECT_GT(right, 0.85);
}

TEST(SurfaceAgreement, MeanCountsWhatViewsShow) {
  SurfaceAgreement agreement;
  EXPECT_EQ(agreement.Mean(), 0);
  // Three views, one view and none see a point. One view alone measures
  // nothing.
  agreement.scores = {0.8f, -1, -1};
  agreement.is_measured = {1, 0, 0};
  agreement.shown = {3, 1, 0};
  EXPECT_FLOAT_EQ(float(agreement.Mean()), 0.6f);
}

}  // namespace
}  // namespace octacut
