#include "core/refine/view_choice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::RefineScene;

class ViewChoice : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new RefineScene(testing::MakeRefineScene());
  }
  static void TearDownTestSuite() { delete scene_; }

  std::vector<LocalSurface> Fit(const IndexedMesh& mesh) const {
    return FitLocalSurfaces(mesh,
                            RefineScene::Neighbors(mesh),
                            testing::AllVertices(mesh),
                            0.03,
                            Context(2));
  }
  const ViewSet& Views() const { return scene_->test.views; }
  // For `surfaces` before `mesh`.
  std::vector<ChosenViews> Choose(const IndexedMesh& mesh,
                                  const std::vector<LocalSurface>& surfaces,
                                  const ViewChoiceOptions& options,
                                  LinesOfSight lines = {.clearance = 0.02},
                                  double pixel = 1) const {
    lines.pixel = pixel;
    return ChooseViews(
        Views(), RayScene(mesh), surfaces, lines, options, Context(2));
  }

  static RefineScene* scene_;
};
RefineScene* ViewChoice::scene_ = nullptr;

TEST_F(ViewChoice, TakesTheMostFrontalViewsThatSee) {
  const IndexedMesh mesh =
      scene_->ToUnitMesh(RefineScene::Mesh(20, [](const auto&) { return 0; }));
  const std::vector<LocalSurface> surfaces = Fit(mesh);
  ViewChoiceOptions options;
  options.max_views = 5;
  options.max_angle = 60;
  const std::vector<ChosenViews> choices = Choose(mesh, surfaces, options);
  EXPECT_GT(std::count_if(choices.begin(),
                          choices.end(),
                          [](const auto& chosen) { return chosen.count == 5; }),
            choices.size() / 4);
  for (size_t v = 0; v < choices.size(); ++v) {
    const auto cosine = [&](size_t view) {
      return (Views()[view].projection.center - surfaces[v].center)
          .normalized()
          .dot(surfaces[v].normal);
    };
    ASSERT_LE(choices[v].count, 5);
    float last = 1;
    for (int i = 0; i < choices[v].count; ++i) {
      EXPECT_LE(cosine(choices[v].views[i]), last);
      last = cosine(choices[v].views[i]);
      EXPECT_GE(last, 0.5f - 1e-6f);
    }
    // No view that would be better was left out.
    for (size_t view = 0; view < Views().size(); ++view) {
      const auto* const end = choices[v].views.begin() + choices[v].count;
      if (choices[v].count == 5 && cosine(view) > last + 1e-6f) {
        EXPECT_NE(std::find(choices[v].views.begin(), end, view), end);
      }
    }
    if (choices[v].count > 0) {
      EXPECT_NEAR(choices[v].pixel * scene_->test.region.cube.edge,
                  scene_->Pixel(),
                  0.4 * scene_->Pixel());
    }
  }
}

TEST_F(ViewChoice, PatchesThatBendAwayNeedFrontalViews) {
  const IndexedMesh mesh =
      scene_->ToUnitMesh(RefineScene::Mesh(20, [](const auto&) { return 0; }));
  std::vector<LocalSurface> surfaces = Fit(mesh);
  // A patch on a cylinder turns away by half a radian; one in a hollow does
  // not.
  const LinesOfSight lines = {.clearance = 0.02, .patch_radius = 0.05};
  const auto choose = [&](float height) {
    for (LocalSurface& surface : surfaces) {
      surface.uu = height;
      surface.uv = surface.vv = 0;
    }
    return Choose(mesh, surfaces, {}, lines);
  };
  const std::vector<ChosenViews> flat = choose(0);
  const std::vector<ChosenViews> convex = choose(-5);
  const std::vector<ChosenViews> concave = choose(5);
  size_t num_fewer = 0;
  for (size_t v = 0; v < surfaces.size(); ++v) {
    EXPECT_EQ(concave[v].count, flat[v].count);
    EXPECT_GE(convex[v].count, std::min<int>(flat[v].count, 4));
    num_fewer += convex[v].count < flat[v].count;
    for (int i = 4; i < convex[v].count; ++i) {
      const Eigen::Vector3f direction =
          (Views()[convex[v].views[i]].projection.center - surfaces[v].center)
              .normalized();
      // 80 degrees without half a radian.
      EXPECT_GE(direction.dot(surfaces[v].normal), 0.62f);
    }
  }
  EXPECT_GT(num_fewer, surfaces.size() / 10);
}

TEST_F(ViewChoice, KeepsViewsApart) {
  const IndexedMesh mesh =
      scene_->ToUnitMesh(RefineScene::Mesh(8, [](const auto&) { return 0; }));
  const std::vector<LocalSurface> surfaces = Fit(mesh);
  ViewChoiceOptions options;
  options.min_separation = 35;
  const std::vector<ChosenViews> choices = Choose(mesh, surfaces, options);
  size_t num_pairs = 0;
  for (size_t v = 0; v < choices.size(); ++v) {
    for (int i = 0; i < choices[v].count; ++i) {
      for (int j = 0; j < i; ++j) {
        const auto direction = [&](int n) {
          return Eigen::Vector3f(
              (Views()[choices[v].views[n]].projection.center -
               surfaces[v].center)
                  .normalized());
        };
        EXPECT_LE(direction(i).dot(direction(j)), 0.8192f);  // cos 35 degrees
        ++num_pairs;
      }
    }
  }
  EXPECT_GT(num_pairs, choices.size());
}

TEST_F(ViewChoice, WeighsViewsByTheSquareOfTooLargePixels) {
  const IndexedMesh mesh =
      scene_->ToUnitMesh(RefineScene::Mesh(8, [](const auto&) { return 0; }));
  const std::vector<LocalSurface> surfaces = Fit(mesh);
  ViewChoiceOptions options;
  options.max_views = 24;
  const LinesOfSight lines = {.clearance = 0.02};
  const std::vector<ChosenViews> sharp = Choose(mesh, surfaces, options, lines);
  // Much smaller than those of all views.
  const double pixel = 0.1 * scene_->Pixel() / scene_->test.region.cube.edge;
  const std::vector<ChosenViews> blurred =
      Choose(mesh, surfaces, options, lines, pixel);
  size_t num_checked = 0;
  for (size_t v = 0; v < sharp.size(); ++v) {
    for (int i = 0; i < blurred[v].count; ++i) {
      for (int j = 0; j < sharp[v].count; ++j) {
        const uint16_t view = sharp[v].views[j];
        if (blurred[v].views[i] == view) {
          const ViewProjection& projection = Views()[view].projection;
          const double ratio = pixel * projection.focal_length /
                               projection.Homogeneous(surfaces[v].center).z();
          EXPECT_LT(ratio, 0.5);
          EXPECT_NEAR(blurred[v].weights[i],
                      ratio * ratio * sharp[v].weights[j],
                      1e-3 * ratio * ratio);
          ++num_checked;
        }
      }
    }
  }
  EXPECT_GT(num_checked, sharp.size());
}

TEST_F(ViewChoice, LeavesOutViewsBehindAnObstacle) {
  const IndexedMesh mesh =
      scene_->ToUnitMesh(RefineScene::Mesh(8, [](const auto&) { return 0; }));
  // A hood around everything: nothing is seen any more.
  const IndexedMesh hood =
      scene_->ToUnitMesh(RefineScene::Mesh(8, [](const auto&) { return 0.2; }));
  for (const ChosenViews& chosen :
       Choose(Joined(mesh, hood), Fit(mesh), ViewChoiceOptions())) {
    EXPECT_EQ(chosen.count, 0);
  }
}

TEST_F(ViewChoice, SurfaceBehindTheCamerasHidesNothing) {
  const IndexedMesh mesh =
      scene_->ToUnitMesh(RefineScene::Mesh(8, [](const auto&) { return 0; }));
  const IndexedMesh dome =
      scene_->ToUnitMesh(RefineScene::Mesh(8, [](const auto&) { return 100; }));
  const std::vector<ChosenViews> alone =
      Choose(mesh, Fit(mesh), ViewChoiceOptions());
  const std::vector<ChosenViews> below =
      Choose(Joined(mesh, dome), Fit(mesh), ViewChoiceOptions());
  int num_views = 0;
  for (size_t v = 0; v < alone.size(); ++v) {
    EXPECT_EQ(below[v].count, alone[v].count);
    num_views += alone[v].count;
  }
  EXPECT_GT(num_views, alone.size());
}

TEST_F(ViewChoice, LeavesOutViewsFromWhichAPieceIsHiddenInPart) {
  // A wall 0.1 high stands around the north pole, 0.1 away; the rest is smooth.
  const auto away_from_pole = [](const Eigen::Vector3d& direction) {
    return std::acos(direction.z()) * RefineScene::kRadius;
  };
  const IndexedMesh world = RefineScene::Mesh(60, [&](const auto& direction) {
    const double away = away_from_pole(direction);
    return away > 0.1 && away < 0.2 ? 0.1 : 0.0;
  });
  const IndexedMesh mesh = scene_->ToUnitMesh(world);
  const std::vector<LocalSurface> surfaces = Fit(mesh);
  const auto choose = [&](double ring_pixels) {
    return Choose(mesh,
                  surfaces,
                  {.max_angle = 70},
                  {.clearance = 0.005,
                   .ring_radius = ring_pixels,
                   .ring_clearance = 0.005});
  };
  const std::vector<ChosenViews> centers = choose(0);
  const std::vector<ChosenViews> pieces = choose(3);
  int num_at_pole = 0;
  for (size_t v = 0; v < centers.size(); ++v) {
    const double away = away_from_pole(world.positions[v].normalized());
    if (away < 0.03) {
      EXPECT_GT(pieces[v].count, 0);
      EXPECT_LT(pieces[v].count, centers[v].count);
      ++num_at_pole;
    } else if (away > 0.5) {
      EXPECT_EQ(pieces[v].count, centers[v].count);
    }
  }
  EXPECT_GT(num_at_pole, 2);
}

TEST_F(ViewChoice, ThatAPieceTurnsAwayHidesNothing) {
  const IndexedMesh mesh =
      scene_->ToUnitMesh(RefineScene::Mesh(40, [](const auto&) { return 0; }));
  const std::vector<LocalSurface> surfaces = Fit(mesh);
  const auto choose = [&](double ring_radius) {
    return Choose(mesh,
                  surfaces,
                  {.max_angle = 85},
                  {.clearance = 0.02,
                   .ring_radius = ring_radius / scene_->Pixel(),
                   .ring_clearance = 0.002});
  };
  // A third of the radius, or 20 degrees: rings lie beyond many horizons.
  const std::vector<ChosenViews> pieces = choose(RefineScene::kRadius / 3);
  const std::vector<ChosenViews> centers = choose(0);
  size_t num_seen = 0;
  for (size_t v = 0; v < centers.size(); ++v) {
    EXPECT_EQ(pieces[v].count, centers[v].count) << v;
    num_seen += centers[v].count >= 2 ? 1 : 0;
  }
  EXPECT_GT(num_seen, centers.size() / 2);
}

TEST(ViewChoiceOptions, AreChecked) {
  EXPECT_NO_THROW(ViewChoiceOptions().Check());
  EXPECT_THROW(ViewChoiceOptions{.max_angle = 90}.Check(), OptionError);
  EXPECT_THROW(ViewChoiceOptions{.max_views = 1}.Check(), OptionError);
  EXPECT_THROW(ViewChoiceOptions{.max_views = 25}.Check(), OptionError);
  EXPECT_THROW(ViewChoiceOptions{.min_separation = -1}.Check(), OptionError);
}

}  // namespace
}  // namespace octacut
