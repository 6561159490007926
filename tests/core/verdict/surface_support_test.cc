#include "core/verdict/surface_support.h"

#include <gtest/gtest.h>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::MakeRefineScene;
using testing::RefineScene;

PointEvidence Point(float offset, float precision, float hull_distance) {
  PointEvidence point;
  point.area = 1;
  point.num_views = 5;
  point.offset = offset;
  point.precision = precision;
  point.hull_distance = hull_distance;
  return point;
}

TEST(SupportOf, PhotographsDecideWhereTheyTellToAPixel) {
  EXPECT_EQ(SupportOf(Point(0.3f, 5, 0)), Support::kPhotographs);
  EXPECT_EQ(SupportOf(Point(0.3f, 5, 20)), Support::kPhotographs);
  // Too uncertain, elsewhere, not at all.
  EXPECT_EQ(SupportOf(Point(0.3f, 0.5f, 20)), Support::kNothing);
  EXPECT_EQ(SupportOf(Point(1.5f, 5, 20)), Support::kNothing);
  EXPECT_EQ(SupportOf(Point(0, 0, 20)), Support::kNothing);
}

TEST(SupportOf, SilhouettesDecideAtTheHull) {
  EXPECT_EQ(SupportOf(Point(0, 0, 1)), Support::kSilhouettes);
  EXPECT_EQ(SupportOf(Point(0, 0, -3)), Support::kSilhouettes);
  EXPECT_EQ(SupportOf(Point(0, 0, 2)), Support::kNothing);
}

struct Measured {
  std::vector<PointEvidence> points;
  SurfaceSupport support;
};

Measured Measure(const RefineScene& scene,
                 IndexedMesh mesh,
                 const Context& context = Context(2)) {
  Measured measured;
  measured.points =
      MeasureSurfaceEvidence(
          scene.test.views, SurfaceEvidenceOptions(), context, &mesh)
          .values;
  measured.support =
      SumUpSupport(measured.points, scene.test.scene.views, scene.test.views);
  return measured;
}

TEST(SurfaceSupport, PhotographsDecideATexturedBall) {
  const RefineScene scene = MakeRefineScene();
  const Measured measured = Measure(scene, scene.Larger(24, 0));
  const SurfaceSupport& support = measured.support;
  EXPECT_GT(support.photographs, 0.85);
  EXPECT_NEAR(
      support.photographs + support.silhouettes + support.nothing, 1, 1e-5);
  EXPECT_GT(support.agreement, 0.6);
  EXPECT_LT(support.blind.share, 0.05);
  double area = 0;
  for (const PointEvidence& point : measured.points) {
    area += point.area;
  }
  const double radius = RefineScene::kRadius / scene.test.region.cube.edge;
  EXPECT_NEAR(area, 4 * 3.1416 * radius * radius, 0.02 * area);
}

TEST(SurfaceSupport, NothingDecidesABallThatIsTooSmall) {
  const RefineScene scene = MakeRefineScene();
  const SurfaceSupport support = Measure(scene, scene.Larger(24, -5)).support;
  EXPECT_LT(support.photographs, 0.1);
  EXPECT_GT(support.nothing, 0.8);
}

TEST(SurfaceSupport, SilhouettesDecideAPlainBall) {
  SceneSpec spec = testing::RefineSceneSpec();
  spec.texture.kind = TextureKind::kPlain;
  spec.degrade.pixel_noise = 3;  // else its shading tells
  const RefineScene scene{testing::MakeTestScene(spec)};
  const SurfaceSupport support = Measure(scene, scene.Larger(24, 0)).support;
  EXPECT_GT(support.silhouettes, 0.6);
  EXPECT_LT(support.photographs, 0.4);
}

TEST(SurfaceSupport, SaysFromWhereViewsAreMissing) {
  // No camera below the horizon.
  const RefineScene scene = MakeRefineScene(10);
  const BlindPart blind = Measure(scene, scene.Larger(24, 0)).support.blind;
  EXPECT_GT(blind.share, 0.05);
  EXPECT_GT(blind.below, 0.9 * blind.share);
  EXPECT_EQ(blind.hidden, 0);
  ASSERT_TRUE(blind.nearest_view.has_value());
  // One of the lower views.
  const auto height = [&](size_t view) {
    return scene.test.scene.views[view].Center().z();
  };
  double mean = 0;
  for (size_t i = 0; i < scene.test.views.size(); ++i) {
    mean += height(i) / double(scene.test.views.size());
  }
  EXPECT_LT(height(*blind.nearest_view), mean);
}

TEST(SurfaceEvidence, IsTheSameForAnyNumberOfThreads) {
  const RefineScene scene = MakeRefineScene();
  const Measured one = Measure(scene, scene.Larger(16, 1), Context(1));
  const Measured two = Measure(scene, scene.Larger(16, 1), Context(2));
  ASSERT_EQ(one.points.size(), two.points.size());
  for (size_t i = 0; i < one.points.size(); ++i) {
    EXPECT_EQ(one.points[i].offset, two.points[i].offset);
    EXPECT_EQ(one.points[i].agreement, two.points[i].agreement);
    EXPECT_EQ(one.points[i].hull_distance, two.points[i].hull_distance);
  }
}

}  // namespace
}  // namespace octacut
