#include "core/segment/search_region.h"

#include <fmt/format.h>

#include <algorithm>
#include <Eigen/Eigenvalues>
#include <vector>

#include "core/base/error.h"
#include "core/base/median.h"

namespace octacut {
namespace {

constexpr size_t kMinViews = 3;
constexpr int kFixationIterations = 20;
// Least mean square sine of the angles between the axes and their mean: below
// it (axes within two degrees) a few pixels move the common point by as much as
// it is away.
constexpr double kMinSpread = 0.03 * 0.03;

Eigen::Vector3d CenterOf(const Pose& pose) {
  return pose.cam_from_world.Inverse().translation;
}

// The axis through the picture's middle, which for a cropped photograph is not
// the optical axis.
Eigen::Vector3d AxisOf(const Pose& pose) {
  const Eigen::Vector3d ray = pose.camera.Unproject(
      {pose.camera.width / 2.0, pose.camera.height / 2.0});
  return (pose.cam_from_world.rotation.transpose() * ray).normalized();
}

// I - d d^T: what is left of a vector beside the axis.
Eigen::Matrix3d BesideAxis(const Eigen::Vector3d& axis) {
  return Eigen::Matrix3d::Identity() - axis * axis.transpose();
}

// The point with the least sum of distances to the axes, by repeated weighted
// least squares.
Eigen::Vector3d FindFixation(std::span<const Pose> poses) {
  std::vector<double> weights(poses.size(), 1);
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (int iteration = 0; iteration < kFixationIterations; ++iteration) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (size_t i = 0; i < poses.size(); ++i) {
      const Eigen::Matrix3d beside = weights[i] * BesideAxis(AxisOf(poses[i]));
      normal += beside;
      right += beside * CenterOf(poses[i]);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(normal);
    if (eigen.eigenvalues()[0] < kMinSpread * normal.trace() / 2) {
      throw InputError(
          "the photographs: all cameras look in the same direction, so where "
          "the object is cannot be told; at least three views from different "
          "sides are needed (or `bounding_box`)");
    }
    point = normal.ldlt().solve(right);
    for (size_t i = 0; i < poses.size(); ++i) {
      const Eigen::Vector3d offset = point - CenterOf(poses[i]);
      const double distance = (BesideAxis(AxisOf(poses[i])) * offset).norm();
      // Distances below a hundredth of the way to the camera are as good.
      weights[i] = 1 / std::max(distance, 0.01 * offset.norm());
    }
    const double largest = *std::max_element(weights.begin(), weights.end());
    for (double& weight : weights) {
      weight /= largest;
    }
  }
  return point;
}

}  // namespace

cv::Mat DistancesFromCenter(const Pose& pose, const SearchRegion& region) {
  const Eigen::Vector3d center = pose.cam_from_world * region.center;
  cv::Mat distances(pose.camera.height, pose.camera.width, CV_32F);
  for (int y = 0; y < distances.rows; ++y) {
    for (int x = 0; x < distances.cols; ++x) {
      const Eigen::Vector3d ray =
          pose.camera.Unproject({x + 0.5, y + 0.5}).normalized();
      distances.at<float>(y, x) =
          float((center - ray * ray.dot(center)).norm() / region.radius);
    }
  }
  return distances;
}

std::optional<Eigen::Vector2d> PixelOf(const Pose& pose,
                                       const Eigen::Vector3d& point) {
  return pose.camera.ProjectIntoFrame(pose.cam_from_world * point);
}

SearchRegion FindSearchRegion(std::span<const Pose> poses,
                              const std::optional<Eigen::AlignedBox3d>& box) {
  if (poses.size() < kMinViews) {
    throw InputError(fmt::format(
        "the photographs: {} views; at least {} are needed to find the object",
        poses.size(),
        kMinViews));
  }
  SearchRegion region;
  region.box = box;
  region.center = box ? Eigen::Vector3d(box->center()) : FindFixation(poses);
  std::vector<double> radii;
  double reach = 0;  // half of what any view shows at the centre's distance
  size_t num_showing = 0;
  for (const Pose& pose : poses) {
    const auto pixel = PixelOf(pose, region.center);
    if (!pixel) {
      radii.push_back(0);
      continue;
    }
    ++num_showing;
    const Eigen::Vector3d in_cam = pose.cam_from_world * region.center;
    const double left = std::min({pixel->x(),
                                  pixel->y(),
                                  pose.camera.width - pixel->x(),
                                  pose.camera.height - pixel->y()});
    const double pixel_size = in_cam.z() / pose.camera.fx;
    radii.push_back(left * pixel_size);
    const double longest = std::max(pose.camera.width, pose.camera.height);
    // Points nearer than half way to a camera are no object that it shows.
    reach = std::max(reach, std::min(longest * pixel_size, in_cam.norm()) / 2);
  }
  if (num_showing * 2 < poses.size()) {
    throw InputError(
        fmt::format("{}: only {} of {} views show it; `bounding_box` "
                    "says where the object is",
                    box ? "bounding_box" : "the point that the cameras look at",
                    num_showing,
                    poses.size()));
  }
  if (box) {
    region.radius = box->sizes().mean() / 2;
    region.cube.edge = box->sizes().maxCoeff();
  } else {
    region.radius = Median(radii);
    region.cube.edge = 2 * reach;
  }
  region.cube.min_corner =
      region.center - Eigen::Vector3d::Constant(region.cube.edge / 2);
  return region;
}

}  // namespace octacut
