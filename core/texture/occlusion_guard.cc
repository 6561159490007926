#include "core/texture/occlusion_guard.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/scene/scene.h"
#include "core/texture/face_views.h"

namespace octacut {
namespace {

// The part of the line `from` + t * `along`, t from 0 to 1, that is in a frame
// or a disc's radius beside it; begins after its end where there is none.
std::pair<double, double> PartWithin(const Eigen::Vector2d& from,
                                     const Eigen::Vector2d& along,
                                     const Eigen::Vector2d& size) {
  double begin = 0;
  double end = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = -kGuardPixels - from[axis];
    const double high = size[axis] + kGuardPixels - from[axis];
    if (along[axis] == 0) {
      if (low > 0 || high < 0) {
        return {1, 0};
      }
      continue;
    }
    begin = std::max(begin, std::min(low / along[axis], high / along[axis]));
    end = std::min(end, std::max(low / along[axis], high / along[axis]));
  }
  return {begin, end};
}

}  // namespace

OcclusionGuard::OcclusionGuard(const PinholeCamera& camera,
                               const cv::Mat& mask,
                               double tolerance)
    : camera_(camera),
      contours_(camera.height,
                camera.width,
                CV_32F,
                cv::Scalar(std::numeric_limits<float>::infinity())),
      tolerance_(tolerance) {
  const cv::Mat object = mask >= kObjectThreshold;
  if (cv::countNonZero(object) == int(object.total())) {
    distance_ = cv::Mat(
        object.size(), CV_32F, cv::Scalar(std::numeric_limits<float>::max()));
  } else {
    cv::distanceTransform(object, distance_, cv::DIST_L2, cv::DIST_MASK_5);
  }
}

void OcclusionGuard::AddContours(
    const std::vector<std::array<uint32_t, 3>>& triangles,
    const std::vector<std::array<uint32_t, 3>>& neighbors,
    const std::vector<uint8_t>& is_front,
    const std::vector<Eigen::Vector3f>& in_camera) {
  for (size_t f = 0; f < triangles.size(); ++f) {
    if (!is_front[f]) {
      continue;
    }
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t neighbor = neighbors[f][k];
      if (neighbor == kNoFace || !is_front[neighbor]) {
        DrawEdge(in_camera[triangles[f][k]],
                 in_camera[triangles[f][(k + 1) % 3]]);
      }
    }
  }
}

void OcclusionGuard::DrawEdge(const Eigen::Vector3f& a,
                              const Eigen::Vector3f& b) {
  if (!(a.z() > 0) || !(b.z() > 0)) {
    return;
  }
  const Eigen::Vector2d from = camera_.Project(a.cast<double>());
  const Eigen::Vector2d along = camera_.Project(b.cast<double>()) - from;
  const Eigen::Vector2d size(camera_.width, camera_.height);
  const auto [begin, end] = PartWithin(from, along, size);
  if (!(begin <= end)) {
    return;
  }
  // Discs a pixel apart cover the line.
  const double length = (end - begin) * along.norm();
  const int steps = std::max(1, int(std::ceil(length)));
  for (int i = 0; i <= steps; ++i) {
    const double t = begin + (end - begin) * i / steps;
    const Eigen::Vector2d pixel = from + t * along;
    // Along the line it is the inverse of the depth that is linear.
    const double depth = 1 / ((1 - t) / a.z() + t / b.z());
    DrawDisc(pixel.x(), pixel.y(), float(depth));
  }
}

void OcclusionGuard::DrawDisc(double u, double v, float depth) {
  const int x0 = std::max(0, int(std::ceil(u - 0.5 - kGuardPixels)));
  const int y0 = std::max(0, int(std::ceil(v - 0.5 - kGuardPixels)));
  const int x1 =
      std::min(contours_.cols - 1, int(std::floor(u - 0.5 + kGuardPixels)));
  const int y1 =
      std::min(contours_.rows - 1, int(std::floor(v - 0.5 + kGuardPixels)));
  for (int y = y0; y <= y1; ++y) {
    float* const row = contours_.ptr<float>(y);
    for (int x = x0; x <= x1; ++x) {
      const double dx = x + 0.5 - u;
      const double dy = y + 0.5 - v;
      if (dx * dx + dy * dy <= kGuardPixels * kGuardPixels) {
        row[x] = std::min(row[x], depth);
      }
    }
  }
}

float OcclusionGuard::Distance(double u, double v) const {
  if (!(u >= 0 && v >= 0 && u < distance_.cols && v < distance_.rows)) {
    return 0;
  }
  return distance_.at<float>(int(v), int(u));
}

bool OcclusionGuard::IsSure(double u, double v, double depth) const {
  return Distance(u, v) > kGuardPixels &&
         depth < double(contours_.at<float>(int(v), int(u))) - tolerance_;
}

}  // namespace octacut
