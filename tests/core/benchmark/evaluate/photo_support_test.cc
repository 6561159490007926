// Support by photographs, and whether meshes differ by more than chance.
#include "core/benchmark/evaluate/photo_support.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/benchmark/evaluate/evaluate_mesh.h"
#include "core/benchmark/evaluate/mean_colors.h"
#include "core/benchmark/evaluate/paired_bootstrap.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"

namespace octacut {
namespace {

std::vector<ViewSupport> SupportsOf(const std::vector<double>& values) {
  std::vector<ViewSupport> supports;
  for (const double value : values) {
    supports.push_back({100, 100, value});
  }
  return supports;
}

TEST(ContradictingViews, StandOutFromTheOthers) {
  const std::vector<bool> found = ContradictingViews(
      SupportsOf({0.80, 0.82, 0.78, 0.81, 0.79, 0.50, 0.80, 0.99}));
  for (size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i], i == 5) << i;
  }
  // All alike: 0.03 less is usual.
  EXPECT_FALSE(ContradictingViews(SupportsOf({0.8, 0.8, 0.8, 0.77}))[3]);
  EXPECT_TRUE(ContradictingViews({}).empty());
}

TEST(MeanSupport, LeavesOutViewsWithoutTexture) {
  std::vector<ViewSupport> supports = SupportsOf({0.5, 0.7});
  supports.push_back({0, 0, 0});
  EXPECT_NEAR(MeanSupport(supports), 0.6, 1e-12);
  EXPECT_EQ(MeanSupport({}), 0);
}

TEST(PairedBootstrap, KnowsChanceFromDifference) {
  std::vector<double> a;
  std::vector<double> b;
  std::vector<double> c;
  for (int i = 0; i < 40; ++i) {
    // Views differ far more than meshes do: only pairs show the difference.
    const double view = 0.3 + 0.015 * i;
    a.push_back(view + 0.010 + 0.004 * ((i * 7) % 5 - 2));
    b.push_back(view);
    c.push_back(view + (i % 2 == 0 ? 0.02 : -0.02));
  }
  const BootstrapDifference better = PairedBootstrap(a, b, 1);
  EXPECT_NEAR(better.mean, 0.010, 1e-9);
  EXPECT_TRUE(better.IsMoreThanChance());
  EXPECT_EQ(better.p_value, 0);
  // The standard error is 0.0057 / sqrt(40) = 0.0009.
  EXPECT_NEAR(better.low, 0.010 - 1.96 * 0.0009, 0.0004);
  EXPECT_NEAR(better.high, 0.010 + 1.96 * 0.0009, 0.0004);
  const BootstrapDifference chance = PairedBootstrap(c, b, 1);
  EXPECT_FALSE(chance.IsMoreThanChance());
  EXPECT_GT(chance.p_value, 0.5);
  const BootstrapDifference again = PairedBootstrap(a, b, 1);
  EXPECT_EQ(again.low, better.low);
  EXPECT_FALSE(PairedBootstrap(b, b, 1).IsMoreThanChance());
  EXPECT_EQ(PairedBootstrap(b, b, 1).p_value, 1);
  EXPECT_THROW(PairedBootstrap({}, {}, 1), InputError);
}

class PhotoSupportTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    synthetic_ = new SyntheticScene(
        MakeScene(QuickScene("torus", 200, 150, 20), Context(2)));
    scene_ = new Scene(ToScene(*synthetic_));
  }
  static void TearDownTestSuite() {
    delete synthetic_;
    delete scene_;
    synthetic_ = nullptr;
    scene_ = nullptr;
  }
  static MeshEvaluation Evaluate(const IndexedMesh& mesh) {
    EvaluateMeshOptions options;
    options.reprojection.keep_maps = true;
    return EvaluateMesh(mesh, scene_->views, options, Context(2));
  }

  static inline SyntheticScene* synthetic_ = nullptr;
  static inline Scene* scene_ = nullptr;
};

TEST_F(PhotoSupportTest, ADentLosesSupportWhereItIs) {
  IndexedMesh dented = synthetic_->reference;
  std::vector<bool> is_dent(dented.positions.size());
  const MeshEvaluation truth = Evaluate(synthetic_->reference);
  // Where the photographs know the surface best.
  size_t best = 0;
  for (size_t i = 0; i < truth.vertex_support.size(); ++i) {
    if (truth.vertex_support[i] > truth.vertex_support[best] ||
        std::isnan(truth.vertex_support[best])) {
      best = i;
    }
  }
  const Eigen::Vector3d middle = dented.positions[best];
  for (size_t i = 0; i < dented.positions.size(); ++i) {
    const double distance = (dented.positions[i] - middle).norm();
    if (distance < 0.25) {
      dented.positions[i] -=
          0.08 * (1 - distance / 0.25) * dented.normals[i].cast<double>();
      is_dent[i] = distance < 0.12;
    }
  }
  const MeshEvaluation wrong = Evaluate(dented);
  EXPECT_GT(MeanSupport(truth.view_support), MeanSupport(wrong.view_support));
  ASSERT_EQ(wrong.vertex_support.size(), is_dent.size());
  double inside[2] = {0, 0};
  double count[2] = {0, 0};
  for (size_t i = 0; i < is_dent.size(); ++i) {
    if (!std::isnan(wrong.vertex_support[i])) {
      inside[is_dent[i]] += wrong.vertex_support[i];
      ++count[is_dent[i]];
    }
  }
  ASSERT_GT(count[1], 3);
  EXPECT_LT(inside[1] / count[1], inside[0] / count[0] - 0.2);
}

TEST_F(PhotoSupportTest, HalfAMeshHasHalfTheSupport) {
  IndexedMesh half = synthetic_->reference;
  std::erase_if(half.triangles, [&](const auto& triangle) {
    return half.positions[triangle[0]].x() > 0;
  });
  const MeshEvaluation whole = Evaluate(synthetic_->reference);
  const MeshEvaluation part = Evaluate(half);
  // What is there is as right as before.
  EXPECT_LT(MeanSupport(part.view_support),
            0.75 * MeanSupport(whole.view_support));
  EXPECT_EQ(part.view_support[0].textured_pixels,
            whole.view_support[0].textured_pixels);
}

TEST_F(PhotoSupportTest, MeanColorsAreThoseOfTheObject) {
  const IndexedMesh& mesh = synthetic_->reference;
  const auto colors = MeanColors(
      mesh.positions, mesh.normals, RayScene(mesh), scene_->views, Context(2));
  // Against one view, at pixels well inside of the object.
  const View& view = scene_->views[3];
  const RayScene rays(mesh);
  double sum = 0;
  int count = 0;
  for (size_t i = 0; i < colors.size(); ++i) {
    const Eigen::Vector3d to_view =
        (view.Center() - mesh.positions[i]).normalized();
    if (mesh.normals[i].cast<double>().dot(to_view) < 0.8 ||
        rays.IsOccluded(
            view.Center(), mesh.positions[i] - view.Center(), 0, 0.99)) {
      continue;
    }
    const Eigen::Vector2d pixel =
        view.camera.Project(view.cam_from_world * mesh.positions[i]);
    const auto& bgr = view.image.at<cv::Vec3b>(int(pixel.y()), int(pixel.x()));
    sum += std::abs(double(bgr[2]) - colors[i][0]) / 255;
    ++count;
  }
  ASSERT_GT(count, 50);
  EXPECT_LT(sum / count, 0.08);
}

}  // namespace
}  // namespace octacut
