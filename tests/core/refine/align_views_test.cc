#include "core/refine/align_views.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "core/refine/refine_options.h"
#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::RefineScene;

// Turns the view about its camera and moves that, so that its image moves by
// some `pixels`.
void Disturb(double pixels, std::mt19937* random, ViewProjection* projection) {
  std::normal_distribution<double> normal(0, pixels);
  const double angle = 1 / double(projection->focal_length);
  Eigen::Vector3d turn;
  Eigen::Vector3d shift;
  for (int i = 0; i < 3; ++i) {
    turn[i] = angle * normal(*random);
    shift[i] = angle * normal(*random);
  }
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  projection->linear = projection->linear * rotation.cast<float>();
  projection->center += shift.cast<float>();
  projection->offset = -projection->linear * projection->center;
}

class AlignViewsTest : public ::testing::Test {
 protected:
  AlignViewsTest()
      : scene_(testing::MakeRefineScene()),
        mesh_(scene_.ToUnitMesh(
            RefineScene::Mesh(16, [](const auto&) { return 0.0; }))),
        surfaces_(FitLocalSurfaces(mesh_,
                                   RefineScene::Neighbors(mesh_),
                                   testing::AllVertices(mesh_),
                                   0.1,
                                   Context(2))) {}

  size_t Align(int steps, const Context& context, ViewSet* views) const {
    const ViewChoiceOptions options;
    size_t num_aligned = 0;
    for (int i = 0; i < steps; ++i) {
      const std::vector<ChosenViews> choices = ChooseViews(*views,
                                                           RayScene(mesh_),
                                                           surfaces_,
                                                           {.clearance = 0.02},
                                                           options,
                                                           context);
      num_aligned =
          AlignViews(surfaces_, choices, PatchOptions(), context, views);
    }
    return num_aligned;
  }

  double Motion(const std::vector<ViewProjection>& before,
                const ViewSet& views) const {
    return MeasureViewMotion(before, views, mesh_.positions).mean;
  }

  RefineScene scene_;
  IndexedMesh mesh_;
  std::vector<LocalSurface> surfaces_;
};

TEST_F(AlignViewsTest, LeavesExactPosesAlone) {
  ViewSet views = scene_.test.views;
  const std::vector<ViewProjection> exact = Projections(views);
  EXPECT_EQ(Align(4, Context(2), &views), views.size());
  EXPECT_LT(Motion(exact, views), 0.03);
}

TEST_F(AlignViewsTest, TakesBackWhatPosesAreOffByOneView) {
  ViewSet views = scene_.test.views;
  const std::vector<ViewProjection> exact = Projections(views);
  std::mt19937 random(1);
  Disturb(0.5, &random, &views[3].projection);
  const double before = Motion(exact, views) * double(views.size());
  ASSERT_GT(before, 0.5);
  Align(6, Context(2), &views);
  EXPECT_LT(MeasureViewMotion(exact, views, mesh_.positions).max, before / 5);
}

// All poses are off: what is common to them cannot be known.
TEST_F(AlignViewsTest, BringsViewsThatAreAllOffToAgree) {
  ViewSet views = scene_.test.views;
  const std::vector<ViewProjection> exact = Projections(views);
  std::mt19937 random(2);
  for (PreparedView& view : views) {
    Disturb(0.5, &random, &view.projection);
  }
  const double before = Motion(exact, views);
  ASSERT_GT(before, 0.4);
  Align(6, Context(2), &views);
  EXPECT_LT(Motion(exact, views), before / 2);
}

TEST_F(AlignViewsTest, KeepsCentersAndOffsetsConsistent) {
  ViewSet views = scene_.test.views;
  std::mt19937 random(3);
  Disturb(1, &random, &views[0].projection);
  Align(1, Context(2), &views);
  for (const PreparedView& view : views) {
    const ViewProjection& projection = view.projection;
    EXPECT_LT(projection.Homogeneous(projection.center).norm(),
              1e-3 * projection.focal_length);
    const Eigen::Vector3f ahead =
        projection.center + projection.linear.row(2).transpose();
    EXPECT_NEAR(projection.Homogeneous(ahead).z(), 1, 1e-4);
  }
}

TEST_F(AlignViewsTest, IsTheSameForAnyNumberOfThreads) {
  ViewSet one = scene_.test.views;
  ViewSet three = scene_.test.views;
  Align(1, Context(1), &one);
  Align(1, Context(3), &three);
  for (size_t v = 0; v < one.size(); ++v) {
    EXPECT_EQ(one[v].projection.linear, three[v].projection.linear);
    EXPECT_EQ(one[v].projection.offset, three[v].projection.offset);
  }
}

TEST_F(AlignViewsTest, MovesNothingWhereNothingIsSeen) {
  ViewSet views = scene_.test.views;
  const std::vector<ViewProjection> exact = Projections(views);
  const std::vector<ChosenViews> none(surfaces_.size());
  EXPECT_EQ(AlignViews(surfaces_, none, PatchOptions(), Context(2), &views),
            0u);
  EXPECT_EQ(Motion(exact, views), 0);
}

}  // namespace
}  // namespace octacut
