// Views all around a ball of one colour in surroundings of another.
#pragma once

#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <opencv2/core.hpp>
#include <vector>

#include "core/base/hash.h"
#include "core/segment/segment_object.h"

namespace octacut::testing {

inline constexpr int kRingWidth = 160;
inline constexpr int kRingHeight = 120;
inline constexpr double kRingDistance = 4;
inline constexpr double kRingFocal = 200;

// Camera at `azimuth` and `elevation` (radians) around the origin, looking at
// it.
inline Pose RingPose(double azimuth, double elevation) {
  const Eigen::Vector3d center =
      kRingDistance * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                      std::cos(elevation) * std::sin(azimuth),
                                      std::sin(elevation));
  const Eigen::Vector3d z = -center.normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  Pose pose;
  pose.camera = {kRingWidth,
                 kRingHeight,
                 kRingFocal,
                 kRingFocal,
                 kRingWidth / 2.0,
                 kRingHeight / 2.0};
  pose.cam_from_world.rotation.row(0) = x;
  pose.cam_from_world.rotation.row(1) = z.cross(x);
  pose.cam_from_world.rotation.row(2) = z;
  pose.cam_from_world.translation = -(pose.cam_from_world.rotation * center);
  return pose;
}

inline std::vector<Pose> RingPoses(int count) {
  std::vector<Pose> poses;
  poses.reserve(size_t(count));
  for (int i = 0; i < count; ++i) {
    poses.push_back(
        RingPose(2 * std::numbers::pi * i / count, i % 2 == 0 ? 0.2 : 0.7));
  }
  return poses;
}

struct Ball {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.5;
};

// 255 where the ray through the pixel's centre meets the ball.
inline cv::Mat SilhouetteOf(const Ball& ball, const Pose& pose) {
  cv::Mat mask(pose.camera.height, pose.camera.width, CV_8U);
  const Eigen::Vector3d center = pose.cam_from_world * ball.center;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const Eigen::Vector3d ray =
          pose.camera.Unproject({x + 0.5, y + 0.5}).normalized();
      mask.at<uint8_t>(y, x) =
          (center - ray * ray.dot(center)).norm() < ball.radius ? 255 : 0;
    }
  }
  return mask;
}

// Paints `where` with a colour and noise of +-8 grey levels.
inline void Paint(const cv::Mat& where,
                  const cv::Vec3b& colour,
                  uint64_t seed,
                  cv::Mat* image) {
  for (int y = 0; y < image->rows; ++y) {
    for (int x = 0; x < image->cols; ++x) {
      if (where.at<uint8_t>(y, x) != 0) {
        const double noise =
            16 * HashUniform(HashBits(seed, uint64_t(y), uint64_t(x))) - 8;
        for (int c = 0; c < 3; ++c) {
          image->at<cv::Vec3b>(y, x)[c] =
              cv::saturate_cast<uint8_t>(colour[c] + noise);
        }
      }
    }
  }
}

struct RingScene {
  SegmentationInput input;
  std::vector<cv::Mat> truth;
};

inline const cv::Vec3b kBallColour = {40, 90, 200};
inline const cv::Vec3b kRoomColour = {120, 120, 110};

inline RingScene MakeRingScene(int count, const Ball& ball) {
  RingScene scene;
  for (const Pose& pose : RingPoses(count)) {
    UnsegmentedView& view = scene.input.views.emplace_back();
    view.pose = pose;
    view.image.create(kRingHeight, kRingWidth, CV_8UC3);
    const cv::Mat mask = SilhouetteOf(ball, pose);
    Paint(~mask, kRoomColour, scene.truth.size(), &view.image);
    Paint(mask, kBallColour, scene.truth.size(), &view.image);
    scene.truth.push_back(mask);
  }
  return scene;
}

inline double Overlap(const cv::Mat& a, const cv::Mat& b) {
  return double(cv::countNonZero(a & b)) / cv::countNonZero(a | b);
}

}  // namespace octacut::testing
