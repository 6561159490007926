#include "core/refine/contour_targets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/core/refine/refine_scene.h"
#include "tests/core/views/random_views.h"

namespace octacut {
namespace {

using testing::RefineScene;

class ContourTargets : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new RefineScene(testing::MakeRefineScene());
  }
  static void TearDownTestSuite() { delete scene_; }

  // Normals of the fitted surfaces are off by at most `normal_noise` a
  // coordinate.
  std::vector<ContourTarget> Find(const IndexedMesh& mesh,
                                  const RayScene& rays,
                                  double border_shift = 0,
                                  double normal_noise = 0) const {
    const VertexCorners neighbors = RefineScene::Neighbors(mesh);
    std::vector<LocalSurface> surfaces = FitLocalSurfaces(
        mesh, neighbors, testing::AllVertices(mesh), 0.05, Context(2));
    testing::Random random(5);
    for (LocalSurface& surface : surfaces) {
      surface.normal += random.Point(-normal_noise, normal_noise).cast<float>();
      surface.normal.normalize();
    }
    return FindContourTargets(scene_->test.views,
                              rays,
                              surfaces,
                              neighbors,
                              {.range = 4, .border_shift = border_shift},
                              Context(2));
  }
  IndexedMesh Larger(double pixels) const { return scene_->Larger(32, pixels); }

  static RefineScene* scene_;
};
RefineScene* ContourTargets::scene_ = nullptr;

TEST_F(ContourTargets, LeadToTheBordersOfTheMasks) {
  for (const double pixels : {-1.5, 0.0, 1.0}) {
    const IndexedMesh mesh = Larger(pixels);
    const std::vector<ContourTarget> targets = Find(mesh, RayScene(mesh));
    // Every view has an occluding contour that crosses some hundred edges.
    EXPECT_GT(targets.size(), 100 * scene_->test.views.size());
    double sum = 0;
    for (const ContourTarget& target : targets) {
      EXPECT_GE(target.edge.fraction, 0);
      EXPECT_LE(target.edge.fraction, 1);
      sum += target.edge.target;
    }
    EXPECT_NEAR(sum / double(targets.size()) * scene_->test.region.cube.edge /
                    scene_->Pixel(),
                -pixels,
                0.2);
  }
}

TEST_F(ContourTargets, AreAsFarAsTheMeshIsFromTheBorders) {
  EXPECT_EQ(MedianDistance({}), std::nullopt);
  for (const double pixels : {-1.5, 0.0, 1.0}) {
    const IndexedMesh mesh = Larger(pixels);
    const std::optional<double> distance =
        MedianDistance(Find(mesh, RayScene(mesh)));
    ASSERT_TRUE(distance);
    EXPECT_NEAR(*distance, std::abs(pixels), 0.2);
  }
}

TEST_F(ContourTargets, LeadBesideBordersThatAreShifted) {
  const IndexedMesh mesh = Larger(0);
  const double pixel = scene_->Pixel() / scene_->test.region.cube.edge;
  for (const double shift : {-6.0, -1.0, 2.0, 6.0}) {
    const std::vector<ContourTarget> targets =
        Find(mesh, RayScene(mesh), shift);
    double sum = 0;
    for (const ContourTarget& target : targets) {
      sum += target.edge.target / pixel;
    }
    if (std::abs(shift) > 4) {
      EXPECT_TRUE(targets.empty()) << "a shift of " << shift;
    } else {
      ASSERT_GT(targets.size(), 100 * scene_->test.views.size());
      EXPECT_NEAR(sum / double(targets.size()), -shift, 0.2);
    }
  }
}

// Points beside the contour, where noisy normals turn away from the view, are
// inside of the border where the surface is right.
TEST_F(ContourTargets, AreNotLedOutwardByNoisyNormals) {
  const IndexedMesh mesh = Larger(0);
  const double pixel = scene_->Pixel() / scene_->test.region.cube.edge;
  double sum = 0;
  const std::vector<ContourTarget> targets = Find(mesh, RayScene(mesh), 0, 0.3);
  for (const ContourTarget& target : targets) {
    sum += target.edge.target / pixel;
  }
  ASSERT_GT(targets.size(), 100 * scene_->test.views.size());
  EXPECT_NEAR(sum / double(targets.size()), 0, 0.1);
}

TEST_F(ContourTargets, OnlyWhereTheMeshEnds) {
  // Before a larger sphere the small one has occluding contours, but no view
  // shows them.
  const IndexedMesh mesh = Larger(0);
  EXPECT_TRUE(Find(mesh, RayScene(Larger(5))).empty());
}

TEST_F(ContourTargets, OnlyWithinTheRange) {
  const IndexedMesh mesh = Larger(-8);
  EXPECT_TRUE(Find(mesh, RayScene(mesh)).empty());
}

}  // namespace
}  // namespace octacut
