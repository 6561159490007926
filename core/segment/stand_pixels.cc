#include "core/segment/stand_pixels.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/ramp.h"

namespace octacut {
namespace {

// Between directions of views, degrees: narrower, points near the plane hardly
// move; wider, it looks different.
constexpr double kLeastAngle = 8;
constexpr double kMostAngle = 50;
constexpr size_t kNeighbors = 8;
constexpr double kWindowDeviation = 2.25;
// Correlations from which on two views show the same texture, and up to which
// they show different ones (docs/experiments/mask_stand.md).
constexpr float kSame = 0.8f;
constexpr float kMaybeSame = 0.6f;
constexpr float kDifferent = 0.3f;
// What changes over more pixels is shading.
constexpr double kTextureScale = 3;
// Squared grey levels: the noise of a photograph and its compression.
constexpr float kNoiseVariance = 4;
// Radii of the region from which on rays are away from the middle.
constexpr float kOutside = 0.5f;
// Least part of the pixels away from the middle that show the plane, and least
// number of pixels that hide it, for each that shows it
// (docs/experiments/mask_stand.md).
constexpr double kLeastShareOfStand = 0.01;
constexpr double kLeastHidden = 0.01;

// The texture of a picture, without its brightness.
cv::Mat TextureOf(const cv::Mat& grey) {
  cv::Mat smooth;
  cv::GaussianBlur(grey, smooth, cv::Size(), kTextureScale);
  return grey - smooth;
}

cv::Mat MeanInWindows(const cv::Mat& values) {
  cv::Mat mean;
  cv::GaussianBlur(
      values, mean, cv::Size(kStandWindow, kStandWindow), kWindowDeviation);
  return mean;
}

// A texture and what correlations need of it.
struct Texture {
  explicit Texture(const cv::Mat& grey)
      : values(TextureOf(grey)), mean(MeanInWindows(values)) {
    cv::Mat variance = MeanInWindows(values.mul(values)) - mean.mul(mean);
    cv::max(variance, kNoiseVariance, variance);
    cv::sqrt(variance, deviation);
  }

  cv::Mat values;
  cv::Mat mean;
  cv::Mat deviation;
};

cv::Mat Correlation(const Texture& a, const Texture& b) {
  cv::Mat covariance =
      MeanInWindows(a.values.mul(b.values)) - a.mean.mul(b.mean);
  cv::Mat correlation;
  cv::divide(covariance, a.deviation.mul(b.deviation), correlation);
  return correlation;
}

// Where a camera's pixels see the plane in another one's picture; -1 where they
// do not.
cv::Mat PixelsByWayOf(const Eigen::Hyperplane<double, 3>& plane,
                      const Pose& from,
                      const Pose& to) {
  const Rigid3d world_from_cam = from.cam_from_world.Inverse();
  const Eigen::Vector3d& eye = world_from_cam.translation;
  const double height = plane.signedDistance(eye);
  cv::Mat pixels(from.camera.height, from.camera.width, CV_32FC2);
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      const Eigen::Vector3d ray =
          world_from_cam.rotation * from.camera.Unproject({x + 0.5, y + 0.5});
      const double distance = -height / plane.normal().dot(ray);
      auto& pixel = pixels.at<cv::Vec2f>(y, x);
      pixel = cv::Vec2f(-1, -1);
      const Eigen::Vector3d point = eye + distance * ray;
      const auto seen = PixelOf(to, point);
      if (distance > 0 && seen) {
        pixel = cv::Vec2f(float(seen->x() - 0.5), float(seen->y() - 0.5));
      }
    }
  }
  return pixels;
}

// A view as another one would see it if all of it were on the plane.
struct CarriedView {
  Texture texture;
  cv::Mat is_outside;  // windows that the view does not show as a whole
};

CarriedView CarryByWayOf(const Eigen::Hyperplane<double, 3>& plane,
                         const cv::Mat& grey,
                         const Pose& pose,
                         const Pose& other) {
  const cv::Mat pixels = PixelsByWayOf(plane, other, pose);
  cv::Mat carried;
  cv::remap(grey,
            carried,
            pixels,
            cv::noArray(),
            cv::INTER_LINEAR,
            cv::BORDER_REPLICATE);
  cv::Mat column;
  cv::extractChannel(pixels, column, 0);
  cv::Mat is_outside;
  cv::dilate(column <= -1,
             is_outside,
             cv::Mat::ones(kStandWindow, kStandWindow, CV_8U));
  return {Texture(carried), is_outside};
}

cv::Mat RampOf(const cv::Mat& values, float zero, float one) {
  cv::Mat result = values.clone();
  for (float& value : cv::Mat_<float>(result)) {
    value = Ramp(value, zero, one);
  }
  return result;
}

// FindStandPixels for a view and what the others show of the plane.
cv::Mat StandOf(const Texture& view, std::span<const CarriedView> others) {
  cv::Mat best(view.values.size(), CV_32F, cv::Scalar(-1));
  cv::Mat second = best.clone();  // the object may hide the plane in one
  cv::Mat of_others = best.clone();
  for (size_t j = 0; j < others.size(); ++j) {
    cv::Mat correlation = Correlation(view, others[j].texture);
    correlation.setTo(-1, others[j].is_outside);
    second = cv::max(second, cv::min(best, correlation));
    best = cv::max(best, correlation);
    for (size_t k = 0; k < j; ++k) {
      correlation = Correlation(others[k].texture, others[j].texture);
      correlation.setTo(-1, others[k].is_outside | others[j].is_outside);
      of_others = cv::max(of_others, correlation);
    }
  }
  cv::Mat hidden = RampOf(of_others, kMaybeSame, kSame)
                       .mul(RampOf(second, kMaybeSame, kDifferent));
  // Windows reach across the border of the object.
  cv::erode(hidden, hidden, cv::Mat::ones(3, 3, CV_8U));
  return RampOf(second, kMaybeSame, kSame) - hidden;
}

std::vector<size_t> NeighborsOf(size_t view,
                                std::span<const Pose> poses,
                                const Eigen::Vector3d& center) {
  const auto direction = [&](const Pose& pose) -> Eigen::Vector3d {
    return (pose.cam_from_world.Inverse().translation - center).normalized();
  };
  std::vector<std::pair<double, size_t>> neighbors;
  for (size_t i = 0; i < poses.size(); ++i) {
    const double cosine = direction(poses[i]).dot(direction(poses[view]));
    const double angle =
        std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    if (angle >= kLeastAngle && angle <= kMostAngle) {
      neighbors.emplace_back(angle, i);
    }
  }
  std::sort(neighbors.begin(), neighbors.end());
  neighbors.resize(std::min(neighbors.size(), kNeighbors));
  std::vector<size_t> result;
  result.reserve(neighbors.size());
  for (const auto& [angle, i] : neighbors) {
    result.push_back(i);
  }
  return result;
}

}  // namespace

std::vector<cv::Mat> FindStandPixels(std::span<const cv::Mat> images,
                                     std::span<const Pose> poses,
                                     const Eigen::Hyperplane<double, 3>& plane,
                                     const Eigen::Vector3d& center,
                                     const Context& context) {
  std::vector<cv::Mat> greys(images.size());
  for (size_t i = 0; i < images.size(); ++i) {
    cv::Mat grey;
    cv::cvtColor(images[i], grey, cv::COLOR_BGR2GRAY);
    grey.convertTo(greys[i], CV_32F);
  }
  Phase phase(context, "search for the stand", images.size());
  std::vector<cv::Mat> result(images.size());
  ParallelEach(context, images.size(), 1, [&](size_t i) {
    std::vector<CarriedView> others;
    for (const size_t j : NeighborsOf(i, poses, center)) {
      others.push_back(CarryByWayOf(plane, greys[j], poses[j], poses[i]));
    }
    result[i] = StandOf(Texture(greys[i]), others);
    phase.Advance();
  });
  return result;
}

bool IsStand(std::span<const cv::Mat> stand,
             std::span<const Pose> poses,
             const SearchRegion& region) {
  double num_outside = 0;
  double num_shown_outside = 0;
  double num_shown = 0;
  double num_hidden = 0;
  for (size_t i = 0; i < poses.size(); ++i) {
    const cv::Mat outside = DistancesFromCenter(poses[i], region) >= kOutside;
    const cv::Mat shown = stand[i] >= 1;
    num_outside += cv::countNonZero(outside);
    num_shown_outside += cv::countNonZero(shown & outside);
    num_shown += cv::countNonZero(shown);
    num_hidden += cv::countNonZero(stand[i] <= -1);
  }
  return num_shown_outside >= kLeastShareOfStand * num_outside &&
         num_hidden >= kLeastHidden * num_shown;
}

}  // namespace octacut
