#include "core/views/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "core/scene/pixel_distance.h"

namespace octacut {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kDistanceScale = 32;

// From the centres of pixels to the object's border. Where a pixel is covered
// in part, the border is in it; elsewhere it lies half-way to the nearest pixel
// of the other kind.
std::vector<int16_t> SignedDistances(const cv::Mat& mask,
                                     const cv::Mat& unknown) {
  const cv::Mat object = mask >= kObjectThreshold;
  const cv::Mat known_object =
      unknown.empty() ? object : cv::Mat(object & ~unknown);
  const cv::Mat inside = DistancesToZero(object);
  const cv::Mat outside = DistancesToZero(~known_object);
  std::vector<int16_t> distances;
  distances.reserve(mask.total());
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const uint8_t coverage = mask.at<uint8_t>(y, x);
      const float to_background = inside.at<float>(y, x);
      const float to_object = outside.at<float>(y, x);
      float distance =
          to_background > 0 ? to_background - 0.5f : 0.5f - to_object;
      if (std::abs(distance) < 1 && coverage > 0 && coverage < 255) {
        distance = (float(coverage) - kObjectCoverage) / 255;
      }
      distances.push_back(int16_t(
          std::lround(kDistanceScale * std::clamp(distance,
                                                  -Silhouette::kFarInside,
                                                  Silhouette::kFarInside))));
    }
  }
  return distances;
}

// The frame without the lines at its sides that hold unknown pixels: always
// the line with the largest share of them goes first. On a side that has lost
// lines, one pixel more goes, from which bilinear values reach beyond. Out of
// the frame where unknown pixels lie amid known ones, or nothing is left.
cv::Rect2f KnownRectangle(const cv::Size& frame, const cv::Mat& unknown) {
  const cv::Rect2f nothing(-1, -1, 0, 0);
  cv::Rect known(cv::Point(), frame);
  if (!unknown.empty()) {
    while (!known.empty()) {
      const auto [x, y, width, height] = known;
      const std::array<cv::Rect, 4> sides = {
          cv::Rect(x, y, 1, height),
          cv::Rect(x + width - 1, y, 1, height),
          cv::Rect(x, y, width, 1),
          cv::Rect(x, y + height - 1, width, 1)};
      std::array<double, 4> shares;
      std::transform(
          sides.begin(), sides.end(), shares.begin(), [&](const auto& side) {
            return cv::countNonZero(unknown(side)) / double(side.area());
          });
      const auto worst = std::max_element(shares.begin(), shares.end());
      if (*worst == 0) {
        if (cv::countNonZero(unknown(known)) == 0) {
          break;
        }
        return nothing;
      }
      const auto side = worst - shares.begin();
      known.x += side == 0;
      known.y += side == 2;
      known.width -= side < 2;
      known.height -= side >= 2;
    }
  }
  const cv::Point begin(known.x + (known.x > 0), known.y + (known.y > 0));
  const cv::Point end(known.br().x - (known.br().x < frame.width),
                      known.br().y - (known.br().y < frame.height));
  const bool is_empty = begin.x >= end.x || begin.y >= end.y;
  return is_empty ? nothing : cv::Rect2f(cv::Rect(begin, end));
}

}  // namespace

Silhouette::Silhouette(const cv::Mat& mask, const cv::Mat& unknown)
    : width_(mask.cols),
      height_(mask.rows),
      sums_(size_t(width_ + 1) * (height_ + 1), 0),
      mask_(mask),
      known_(KnownRectangle(mask.size(), unknown)),
      distances_(SignedDistances(mask, unknown)) {
  const size_t stride = size_t(width_) + 1;
  for (int y = 0; y < height_; ++y) {
    const uint8_t* row = mask.ptr<uint8_t>(y);
    uint32_t row_sum = 0;
    for (int x = 0; x < width_; ++x) {
      row_sum += row[x] >= kObjectThreshold ? 1 : 0;
      sums_[(y + 1) * stride + x + 1] = sums_[y * stride + x + 1] + row_sum;
      if (!unknown.empty() && unknown.at<uint8_t>(y, x) != 0) {
        distances_[size_t(y) * width_ + x] = kUnknown;
      }
    }
  }
}

uint32_t Silhouette::CountObject(
    float u0, float v0, float u1, float v1, uint32_t* num_pixels) const {
  const int x0 = std::min(int(u0), width_ - 1);
  const int y0 = std::min(int(v0), height_ - 1);
  const int x1 = std::min(int(u1), width_ - 1) + 1;
  const int y1 = std::min(int(v1), height_ - 1) + 1;
  *num_pixels = uint32_t(x1 - x0) * uint32_t(y1 - y0);
  const size_t stride = size_t(width_) + 1;
  return sums_[y1 * stride + x1] - sums_[y0 * stride + x1] -
         sums_[y1 * stride + x0] + sums_[y0 * stride + x0];
}

Containment Silhouette::Test(
    float u0, float v0, float u1, float v1, float margin) const {
  // Negated so that NaN, too, tells nothing.
  if (!(u0 >= 0 && v0 >= 0 && u1 <= float(width_) && v1 <= float(height_))) {
    return Containment::kMixed;
  }
  uint32_t num_pixels;
  const uint32_t count = CountObject(u0, v0, u1, v1, &num_pixels);
  if (count > 0) {
    return count == num_pixels ? Containment::kObject : Containment::kMixed;
  }
  const bool is_far =
      margin == 0 || CountObject(std::max(u0 - margin, 0.0f),
                                 std::max(v0 - margin, 0.0f),
                                 std::min(u1 + margin, float(width_)),
                                 std::min(v1 + margin, float(height_)),
                                 &num_pixels) == 0;
  return is_far ? Containment::kBackground : Containment::kMixed;
}

Containment Silhouette::TestCube(const ViewProjection& projection,
                                 const Eigen::Vector3f& center,
                                 float half_edge,
                                 float margin) const {
  const Eigen::Vector3f h = projection.Homogeneous(center);
  const Eigen::Matrix3f axes = projection.linear * half_edge;
  float u_min = kInfinity, u_max = -kInfinity;
  float v_min = kInfinity, v_max = -kInfinity;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3f p = h;
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis) & 1) {
        p += axes.col(axis);
      } else {
        p -= axes.col(axis);
      }
    }
    if (!(p.z() > 0)) {
      return Containment::kMixed;
    }
    const float inverse_depth = 1 / p.z();
    u_min = std::min(u_min, p.x() * inverse_depth);
    u_max = std::max(u_max, p.x() * inverse_depth);
    v_min = std::min(v_min, p.y() * inverse_depth);
    v_max = std::max(v_max, p.y() * inverse_depth);
  }
  return Test(u_min, v_min, u_max, v_max, margin);
}

bool Silhouette::IsBackgroundCube(const ViewProjection& projection,
                                  const Eigen::Vector3f& center,
                                  float half_edge,
                                  float margin) const {
  const std::optional<ProjectedPoint> p = projection.Project(center);
  if (!p ||
      !(p->u >= 0 && p->v >= 0 && p->u < float(width_) &&
        p->v < float(height_)) ||
      mask_.ptr<uint8_t>(int(p->v))[int(p->u)] >= kObjectThreshold) {
    return false;
  }
  return TestCube(projection, center, half_edge, margin) ==
         Containment::kBackground;
}

float Silhouette::SignedDistance(float u, float v) const {
  if (!(u >= 0 && v >= 0 && u <= float(width_) && v <= float(height_))) {
    return kFarInside;
  }
  const float x = std::clamp(u - 0.5f, 0.0f, float(width_ - 1));
  const float y = std::clamp(v - 0.5f, 0.0f, float(height_ - 1));
  const int x0 = int(x);
  const int y0 = int(y);
  const int x1 = std::min(x0 + 1, width_ - 1);
  const float fx = x - float(x0);
  const float fy = y - float(y0);
  const int16_t* top = distances_.data() + size_t(y0) * width_;
  const int16_t* bottom =
      distances_.data() + size_t(std::min(y0 + 1, height_ - 1)) * width_;
  const float upper = float(top[x0]) * (1 - fx) + float(top[x1]) * fx;
  const float lower = float(bottom[x0]) * (1 - fx) + float(bottom[x1]) * fx;
  return (upper * (1 - fy) + lower * fy) * (1 / kDistanceScale);
}

float Silhouette::Coverage(float u, float v) const {
  if (!(u >= 0 && v >= 0 && u <= float(width_) && v <= float(height_))) {
    return 255;
  }
  const float x = std::clamp(u - 0.5f, 0.0f, float(width_ - 1));
  const float y = std::clamp(v - 0.5f, 0.0f, float(height_ - 1));
  const int x0 = int(x);
  const int y0 = int(y);
  const int x1 = std::min(x0 + 1, width_ - 1);
  const int y1 = std::min(y0 + 1, height_ - 1);
  const float fx = x - float(x0);
  const float fy = y - float(y0);
  const uint8_t* top = mask_.ptr<uint8_t>(y0);
  const uint8_t* bottom = mask_.ptr<uint8_t>(y1);
  return (top[x0] * (1 - fx) + top[x1] * fx) * (1 - fy) +
         (bottom[x0] * (1 - fx) + bottom[x1] * fx) * fy;
}

}  // namespace octacut
