#include "core/benchmark/synthetic/synthetic_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/base/error.h"

namespace octacut {
namespace {

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && a.isContinuous() &&
         b.isContinuous() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

TEST(MakeScene, GivesTheSameBytesForAnyNumberOfThreads) {
  SceneSpec spec = QuickScene("torus", 80, 60, 3);
  spec.reference.resolution = 40;
  spec.degrade.pixel_noise = 2;
  spec.degrade.pose_noise = 0.5;
  const SyntheticScene one = MakeScene(spec, Context(1));
  for (const int num_threads : {2, 4}) {
    const SyntheticScene many = MakeScene(spec, Context(num_threads));
    EXPECT_EQ(one.reference.positions, many.reference.positions);
    EXPECT_EQ(one.reference.triangles, many.reference.triangles);
    ASSERT_EQ(one.views.size(), many.views.size());
    for (size_t i = 0; i < one.views.size(); ++i) {
      EXPECT_TRUE(SameBytes(one.views[i].image, many.views[i].image));
      EXPECT_TRUE(SameBytes(one.views[i].mask, many.views[i].mask));
      EXPECT_EQ(one.views[i].cam_from_world.rotation,
                many.views[i].cam_from_world.rotation);
    }
    EXPECT_EQ(one.points.size(), many.points.size());
  }
}

TEST(MakeScene, SparsePointsLieWhereTheirViewsSeeThem) {
  SceneSpec spec = QuickScene("cup", 160, 120, 8);
  const SyntheticScene scene = MakeScene(spec, Context(2));
  EXPECT_GT(scene.points.size(), 100u);
  for (const SyntheticPoint& point : scene.points) {
    // The reference's triangles stand off the surface a little.
    EXPECT_LT(std::abs(scene.object.shape(point.position)), 2e-3);
    ASSERT_GE(point.observations.size(), 2u);
    for (const auto& observation : point.observations) {
      const SyntheticView& view = scene.views[observation.view];
      const Eigen::Vector2d pixel =
          view.lens.Project(view.cam_from_world * point.position);
      EXPECT_LT((pixel - observation.pixel).norm(), 1e-9);
      // What is seen is object.
      EXPECT_GT(view.mask.at<uint8_t>(static_cast<int>(pixel.y()),
                                      static_cast<int>(pixel.x())),
                0);
    }
  }
}

TEST(MakeScene, ObservationNoiseIsOfTheGivenStrength) {
  SceneSpec spec = QuickScene("sphere", 80, 60, 6);
  spec.reference.resolution = 40;
  spec.observation_noise = 0.5;
  const SyntheticScene scene = MakeScene(spec, Context(2));
  double squares = 0;
  int count = 0;
  for (const SyntheticPoint& point : scene.points) {
    for (const auto& observation : point.observations) {
      const SyntheticView& view = scene.views[observation.view];
      squares += (view.lens.Project(view.cam_from_world * point.position) -
                  observation.pixel)
                     .squaredNorm();
      count += 2;
    }
  }
  EXPECT_NEAR(std::sqrt(squares / count), 0.5, 0.05);
}

TEST(MakeScene, PoseNoiseChangesTheReportNotTheImage) {
  SceneSpec spec = QuickScene("box", 80, 60, 3);
  spec.reference.resolution = 40;
  const SyntheticScene exact = MakeScene(spec, Context(2));
  spec.degrade.pose_noise = 2;
  const SyntheticScene noisy = MakeScene(spec, Context(2));
  for (size_t i = 0; i < exact.views.size(); ++i) {
    EXPECT_TRUE(SameBytes(exact.views[i].image, noisy.views[i].image));
    EXPECT_EQ(noisy.views[i].true_cam_from_world.rotation,
              exact.views[i].cam_from_world.rotation);
    EXPECT_NE(noisy.views[i].cam_from_world.rotation,
              exact.views[i].cam_from_world.rotation);
  }
}

TEST(MakeScene, AnotherSeedGivesOtherNoise) {
  SceneSpec spec = QuickScene("sphere", 80, 60, 2);
  spec.reference.resolution = 40;
  spec.degrade.pixel_noise = 3;
  const SyntheticScene one = MakeScene(spec, Context(2));
  EXPECT_FALSE(SameBytes(one.views[0].image, one.views[1].image));
  spec.seed = 1;
  const SyntheticScene other = MakeScene(spec, Context(2));
  EXPECT_FALSE(SameBytes(one.views[0].image, other.views[0].image));
}

TEST(ToScene, HandsOnWhatTheStepsNeed) {
  SceneSpec spec = QuickScene("sphere", 80, 60, 3);
  spec.reference.resolution = 40;
  const SyntheticScene synthetic = MakeScene(spec, Context(2));
  const Scene scene = ToScene(synthetic);
  ASSERT_EQ(scene.views.size(), 3u);
  EXPECT_EQ(scene.views[1].name, "view_001.jpg");
  EXPECT_EQ(scene.views[1].image.cols, 80);
  EXPECT_EQ(scene.views[1].mask.rows, 60);
  EXPECT_EQ(scene.views[1].camera.width, 80);
  EXPECT_EQ(scene.points.size(), synthetic.points.size());
  spec.rig.k1 = 0.1;
  EXPECT_THROW(ToScene(MakeScene(spec, Context(2))), InputError);
}

TEST(SceneSpec, IsValidForEveryObject) {
  for (const std::string& name : ObjectNames()) {
    EXPECT_NO_THROW(QuickScene(name).Check()) << name;
  }
  SceneSpec spec;
  spec.num_points = -1;
  EXPECT_THROW(spec.Check(), OptionError);
  spec.num_points = 10;
  spec.observation_noise = -1;
  EXPECT_THROW(spec.Check(), OptionError);
  EXPECT_THROW(MakeScene(QuickScene("nothing"), Context(1)), OptionError);
}

}  // namespace
}  // namespace octacut
