#include "core/segment/stand_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/hash.h"
#include "core/base/with_threads.h"
#include "tests/core/segment/ring_scene.h"

namespace octacut::testing {
namespace {

constexpr double kHeight = -0.5;

// Grey levels of spots about three pixels wide, linear between them.
double TextureAt(double u, double v, uint64_t seed) {
  const double x = u / 0.06 + 1000;
  const double y = v / 0.06 + 1000;
  const auto spot = [&](double i, double j) {
    return HashUniform(HashBits(seed, uint64_t(i), uint64_t(j)));
  };
  const double a = x - std::floor(x);
  const double b = y - std::floor(y);
  return 60 + 120 * ((1 - a) * ((1 - b) * spot(x, y) + b * spot(x, y + 1)) +
                     a * ((1 - b) * spot(x + 1, y) + b * spot(x + 1, y + 1)));
}

// A textured ball, if any, above a plane that has a texture up to a radius
// around the origin, in light that differs from view to view.
struct StandScene {
  StandScene(double ball_radius, double plane_radius)
      : poses(RingPoses(24)), region(FindSearchRegion(poses, {})) {
    const Ball ball{{0, 0, 0}, ball_radius};
    for (size_t i = 0; i < poses.size(); ++i) {
      const Pose& pose = poses[i];
      const Rigid3d world_from_cam = pose.cam_from_world.Inverse();
      cv::Mat image(pose.camera.height, pose.camera.width, CV_8UC3);
      cv::Mat plane = cv::Mat::zeros(image.size(), CV_8U);
      const cv::Mat object = SilhouetteOf(ball, pose);
      for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
          const Eigen::Vector3d eye = world_from_cam.translation;
          const Eigen::Vector3d ray = world_from_cam.rotation *
                                      pose.camera.Unproject({x + 0.5, y + 0.5});
          const Eigen::Vector3d point =
              eye + (kHeight - eye.z()) / ray.z() * ray;
          const double radius = point.head<2>().norm();
          double value = 110;
          if (object.at<uint8_t>(y, x) != 0) {
            const Eigen::Vector3d direction = ray.normalized();
            const double middle = -eye.dot(direction);
            const Eigen::Vector3d seen =
                eye + direction * (middle - std::sqrt(std::max(
                                                0.0,
                                                ball.radius * ball.radius -
                                                    eye.squaredNorm() +
                                                    middle * middle)));
            value = TextureAt(seen.x() + 0.7 * seen.z(), seen.y(), 1);
          } else if (ray.z() < 0 && radius < plane_radius) {
            plane.at<uint8_t>(y, x) = 255;
            value = TextureAt(point.x(), point.y(), 2);
          }
          value *= i % 2 == 0 ? 1.0 : 0.6;
          image.at<cv::Vec3b>(y, x) = cv::Vec3b::all(uint8_t(value));
        }
      }
      images.push_back(image);
      planes.push_back(plane);
      objects.push_back(object);
    }
  }

  std::vector<cv::Mat> Find(int num_threads) const {
    return FindStandPixels(images,
                           poses,
                           {Eigen::Vector3d::UnitZ(), -kHeight},
                           region.center,
                           Context(num_threads));
  }

  std::vector<Pose> poses;
  SearchRegion region;
  std::vector<cv::Mat> images;
  std::vector<cv::Mat> planes;   // what shows its texture
  std::vector<cv::Mat> objects;  // silhouettes
};

// The part of the pixels of `mask`, but for those within a window of its
// border.
double PartOf(const cv::Mat& chosen, const cv::Mat& mask) {
  cv::Mat inner;
  cv::erode(mask, inner, cv::Mat::ones(kStandWindow, kStandWindow, CV_8U));
  return double(cv::countNonZero(chosen & inner)) / cv::countNonZero(inner);
}

TEST(StandPixels, ShowThePlaneAndWhatHidesIt) {
  const StandScene scene(0.4, 1.2);
  const std::vector<cv::Mat> stand = scene.Find(2);
  double hidden = 0;
  double mistaken = 0;  // spots that are alike by chance
  for (size_t i = 0; i < stand.size(); ++i) {
    EXPECT_GT(PartOf(stand[i] >= 1, scene.planes[i]), 0.9) << i;
    EXPECT_LT(PartOf(stand[i] < 0, scene.planes[i]), 0.01) << i;
    EXPECT_LT(PartOf(stand[i] >= 1, scene.objects[i]), 0.01) << i;
    mistaken += PartOf(stand[i] > 0, scene.objects[i]) / double(stand.size());
    hidden += PartOf(stand[i] < 0, scene.objects[i]) / double(stand.size());
  }
  // The upper half of the ball hides the room; other views must see the plane.
  EXPECT_GT(hidden, 0.2);
  EXPECT_LT(mistaken, 0.02);
  EXPECT_TRUE(IsStand(stand, scene.poses, scene.region));
}

TEST(StandPixels, APlainPlaneSaysNothing) {
  const StandScene scene(0.4, 0);
  const std::vector<cv::Mat> stand = scene.Find(2);
  for (size_t i = 0; i < stand.size(); ++i) {
    EXPECT_LT(PartOf(stand[i] != 0, ~scene.objects[i]), 0.01) << i;
  }
  EXPECT_FALSE(IsStand(stand, scene.poses, scene.region));
}

// Nothing stands on it, in views from low above as well.
TEST(StandPixels, TheFlatTopOfAnObjectIsNoStand) {
  const StandScene scene(0, 0.9);
  const std::vector<cv::Mat> stand = scene.Find(2);
  EXPECT_FALSE(IsStand(stand, scene.poses, scene.region));
}

TEST(StandPixels, SameBytesForAnyNumberOfThreads) {
  const StandScene scene(0.4, 1.2);
  const std::vector<cv::Mat> one = scene.Find(1);
  std::vector<cv::Mat> three;
  WithThreads(3, [&] { three = scene.Find(3); });
  for (size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(cv::norm(one[i], three[i], cv::NORM_INF), 0) << i;
  }
}

}  // namespace
}  // namespace octacut::testing
