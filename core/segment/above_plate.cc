#include "core/segment/above_plate.h"

#include <algorithm>
#include <cstddef>
#include <Eigen/Core>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/segment/labels.h"
#include "core/segment/occupancy.h"

namespace octacut {
namespace {

// Part of the views in which a point of the plate may be taken for background,
// because it looks like it.
constexpr double kMostStill = 0.25;
// Voxels along an edge of the region.
constexpr int kVoxelsAcross = 96;
// Pixels by which borders may be off.
constexpr int kBorderError = 2;
// Pixels; OpenCV draws no polygon with corners much farther off.
constexpr double kFarOutside = 1 << 20;
// The evidence of more than one view, whatever the sampling.
constexpr float kTwoViewsDeny = -1.5f * kMaxViewLogOdds;

// Where a ray from `origin` meets the plane.
std::optional<Eigen::Vector3d> MeetPlane(
    const Eigen::Vector3d& origin,
    const Eigen::Vector3d& direction,
    const Eigen::Hyperplane<double, 3>& plane) {
  const double depth =
      -plane.signedDistance(origin) / plane.normal().dot(direction);
  if (!(depth > 0)) {
    return std::nullopt;
  }
  return origin + depth * direction;
}

bool IsOfPlate(const Eigen::Vector3d& point,
               std::span<const cv::Mat> labels,
               std::span<const Pose> poses) {
  size_t num_shown = 0;
  size_t num_still = 0;
  for (size_t i = 0; i < poses.size(); ++i) {
    if (const auto pixel = PixelOf(poses[i], point)) {
      ++num_shown;
      num_still += labels[i].at<uint8_t>(int(pixel->y()), int(pixel->x())) ==
                   kSurroundingsLabel;
    }
  }
  return 2 * num_shown > poses.size() &&
         double(num_still) <= kMostStill * double(num_shown);
}

// CV_8U of the view's size: 255 for pixels that can show something of the box.
cv::Mat PixelsOfBox(const Pose& pose, const Eigen::AlignedBox3d& box) {
  const cv::Size size(pose.camera.width, pose.camera.height);
  std::vector<cv::Point2f> corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner =
        pose.cam_from_world * box.corner(Eigen::AlignedBox3d::CornerType(i));
    const Eigen::Vector2d pixel = pose.camera.Project(corner);
    if (!(corner.z() > 0) || pixel.cwiseAbs().maxCoeff() > kFarOutside) {
      return {size, CV_8U, cv::Scalar(255)};
    }
    corners.emplace_back(float(pixel.x() - 0.5), float(pixel.y() - 0.5));
  }
  std::vector<cv::Point2f> outline;
  cv::convexHull(corners, outline);
  cv::Mat pixels(size, CV_8U, cv::Scalar(0));
  const std::vector<cv::Point> rounded(outline.begin(), outline.end());
  cv::fillConvexPoly(pixels, rounded, cv::Scalar(255));
  return pixels;
}

}  // namespace

std::vector<cv::Mat> FindPixelsAbovePlate(
    std::span<const cv::Mat> labels,
    std::span<const Pose> poses,
    const Eigen::Hyperplane<double, 3>& plane,
    const Context& context) {
  std::vector<cv::Mat> above(poses.size());
  ParallelEach(context, poses.size(), 1, [&](size_t i) {
    const Rigid3d world_from_cam = poses[i].cam_from_world.Inverse();
    above[i] = cv::Mat::zeros(labels[i].size(), CV_8U);
    for (int y = 0; y < above[i].rows; ++y) {
      for (int x = 0; x < above[i].cols; ++x) {
        if (labels[i].at<uint8_t>(y, x) == kSurroundingsLabel) {
          continue;
        }
        const Eigen::Vector3d direction =
            world_from_cam.rotation *
            poses[i].camera.Unproject({x + 0.5, y + 0.5});
        const std::optional<Eigen::Vector3d> point =
            MeetPlane(world_from_cam.translation, direction, plane);
        above[i].at<uint8_t>(y, x) =
            point && IsOfPlate(*point, labels, poses) ? 0 : 255;
      }
    }
  });
  return above;
}

double ContradictedPart(std::span<const cv::Mat> labels,
                        std::span<const cv::Mat> above,
                        std::span<const Pose> poses,
                        const Eigen::Hyperplane<double, 3>& plane,
                        const SearchRegion& region,
                        const Context& context) {
  const cv::Mat window =
      cv::Mat::ones(2 * kBorderError + 1, 2 * kBorderError + 1, CV_8U);
  std::vector<cv::Mat> log_odds;
  log_odds.reserve(labels.size());
  for (const cv::Mat& of_view : labels) {
    cv::Mat still;
    cv::erode(of_view == kSurroundingsLabel, still, window);
    cv::Mat& odds =
        log_odds.emplace_back(cv::Mat::zeros(of_view.size(), CV_32F));
    odds.setTo(-2 * kMaxViewLogOdds, still);
  }
  std::vector<cv::Mat> judged(above.begin(), above.end());
  for (size_t i = 0; i < judged.size() && region.box; ++i) {
    judged[i] = above[i] & PixelsOfBox(poses[i], *region.box);
  }
  const OccupancyGrid grid(region.cube,
                           kVoxelsAcross,
                           {region.box, plane},
                           poses,
                           log_odds,
                           context);
  const int64_t num_contradicted =
      ParallelSum(context, poses.size(), 1, [&](size_t i, size_t) {
        return cv::countNonZero((grid.LogOddsOfOthers(i) < kTwoViewsDeny) &
                                judged[i]);
      });
  int64_t num_judged = 0;
  for (const cv::Mat& of_view : judged) {
    num_judged += cv::countNonZero(of_view);
  }
  return double(num_contradicted) / double(std::max<int64_t>(num_judged, 1));
}

}  // namespace octacut
