#include "core/benchmark/synthetic/synthetic_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"

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

TEST(MakeScene, PhotographsAGivenMesh) {
  SceneSpec spec = QuickScene("torus", 80, 60, 3);
  const SyntheticScene torus = MakeScene(spec, Context(2));
  // Somewhere else and in other units.
  IndexedMesh mesh = torus.reference;
  for (Eigen::Vector3d& position : mesh.positions) {
    position = 40 * position + Eigen::Vector3d(300, -20, 7);
  }
  spec.object = "sphere";
  spec.mesh = mesh;
  const SyntheticScene scene = MakeScene(spec, Context(2));
  EXPECT_EQ(scene.object.genus, 1);
  EXPECT_EQ(scene.object.num_components, 1);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : scene.reference.positions) {
    box.extend(position);
  }
  EXPECT_NEAR(box.sizes().maxCoeff(), 2, 1e-12);
  EXPECT_LT(box.center().norm(), 1e-12);
  // The rig frames the object, so the silhouettes are those of the torus.
  ASSERT_EQ(scene.views.size(), 3u);
  for (size_t i = 0; i < scene.views.size(); ++i) {
    EXPECT_LT(cv::norm(scene.views[i].mask, torus.views[i].mask, cv::NORM_L1),
              0.01 * cv::norm(torus.views[i].mask, cv::NORM_L1));
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

// Red of the photograph where the stand is and the object is not.
TEST(MakeScene, AStandIsInThePhotographsNotInTheMasks) {
  SceneSpec spec = QuickScene("vase", 160, 120, 4);
  spec.rig.min_elevation = 20;
  const SyntheticScene bare = MakeScene(spec, Context(2));
  spec.stand.is_there = true;
  spec.stand.texture.kind = TextureKind::kPlain;
  spec.stand.texture.color = {0.9f, 0.02f, 0.02f};
  const SyntheticScene scene = MakeScene(spec, Context(2));
  int num_stand_points = 0;
  for (size_t i = 0; i < scene.views.size(); ++i) {
    // All of the object is above the stand, so it hides nothing; where they
    // touch, rounding decides.
    cv::Mat difference;
    cv::absdiff(scene.views[i].mask, bare.views[i].mask, difference);
    EXPECT_LE(cv::countNonZero(difference > 64), 4);
    int num_red = 0;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) {
        const auto pixel = scene.views[i].image.at<cv::Vec3b>(y, x);
        const bool is_red = pixel[2] > 2 * pixel[1] + 20;
        num_red += is_red;
        EXPECT_FALSE(is_red && scene.views[i].mask.at<uint8_t>(y, x) == 255);
      }
    }
    EXPECT_GT(num_red, 200);
  }
  for (const SyntheticPoint& point : scene.points) {
    num_stand_points += !point.on_object;
    EXPECT_EQ(point.on_object,
              std::abs(scene.object.shape(point.position)) < 2e-3);
  }
  EXPECT_GT(num_stand_points, 10);
  EXPECT_EQ(ToScene(scene).points.size(),
            scene.points.size() - size_t(num_stand_points));
  spec.rig.min_elevation = -40;
  EXPECT_THROW(MakeScene(spec, Context(2)), OptionError);
}

TEST(MakeScene, ATurntablesRoomStandsStill) {
  SceneSpec spec = QuickScene("sphere", 80, 60, 5);
  spec.background.kind = BackgroundKind::kRoom;
  spec.rig.kind = RigKind::kTurntable;
  spec.rig.min_elevation = 20;
  spec.rig.fill = 0.5;
  const SyntheticScene scene = MakeScene(spec, Context(2));
  ASSERT_EQ(scene.empty_set.size(), 4u);
  for (const SyntheticView& view : scene.views) {
    cv::Mat difference;
    cv::absdiff(view.image, scene.empty_set[0], difference);
    difference.setTo(0, view.mask > 0);
    EXPECT_EQ(cv::norm(difference, cv::NORM_INF), 0);
  }
  for (const SyntheticPoint& point : scene.points) {
    EXPECT_TRUE(point.on_object);
  }
  // A room that stands still with the object has points.
  spec.rig.kind = RigKind::kSphere;
  size_t num_room = 0;
  for (const SyntheticPoint& point : MakeScene(spec, Context(2)).points) {
    num_room += !point.on_object;
  }
  EXPECT_GT(num_room, 20u);
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
