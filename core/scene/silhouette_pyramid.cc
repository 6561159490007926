#include "core/scene/silhouette_pyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace octacut {

SilhouettePyramid::SilhouettePyramid(const View& view, bool trust_sides)
    : camera_(view.camera), cam_from_world_(view.cam_from_world) {
  BuildTable(view.mask);
  closed_ = HasObject() && min_x_ > 0 && min_y_ > 0 && max_x_ < camera_.width &&
            max_y_ < camera_.height;
  BuildPlanes(trust_sides);
}

void SilhouettePyramid::BuildTable(const cv::Mat& mask) {
  const int width = mask.cols;
  const int height = mask.rows;
  const size_t stride = size_t(width) + 1;
  table_.assign(stride * (size_t(height) + 1), 0);
  min_x_ = width;
  min_y_ = height;
  max_x_ = max_y_ = 0;
  for (int y = 0; y < height; ++y) {
    const uint8_t* row = mask.ptr<uint8_t>(y);
    uint32_t* sums = table_.data() + (size_t(y) + 1) * stride;
    uint32_t row_sum = 0;
    for (int x = 0; x < width; ++x) {
      if (row[x] >= kObjectThreshold) {
        ++row_sum;
        min_x_ = std::min(min_x_, x);
        max_x_ = std::max(max_x_, x + 1);
        min_y_ = std::min(min_y_, y);
        max_y_ = y + 1;
      }
      sums[x + 1] = sums[x + 1 - stride] + row_sum;
    }
  }
}

void SilhouettePyramid::BuildPlanes(bool trust_sides) {
  if (!HasObject() || !(closed_ || trust_sides)) {
    return;
  }
  const auto add = [&](const Eigen::Vector3d& normal_in_cam) {
    planes_.push_back({cam_from_world_.rotation.transpose() * normal_in_cam,
                       normal_in_cam.dot(cam_from_world_.translation)});
  };
  const Eigen::Vector3d first = camera_.Unproject({min_x_, min_y_});
  const Eigen::Vector3d last = camera_.Unproject({max_x_, max_y_});
  if (min_x_ > 0) add({1, 0, -first.x()});
  if (min_y_ > 0) add({0, 1, -first.y()});
  if (max_x_ < camera_.width) add({-1, 0, last.x()});
  if (max_y_ < camera_.height) add({0, -1, last.y()});
  if (!planes_.empty()) add({0, 0, 1});
}

int64_t SilhouettePyramid::Count(int x0, int y0, int x1, int y1) const {
  const size_t stride = size_t(camera_.width) + 1;
  const uint32_t* top = table_.data() + size_t(y0) * stride;
  const uint32_t* bottom = table_.data() + size_t(y1) * stride;
  return int64_t(bottom[x1]) - bottom[x0] - top[x1] + top[x0];
}

BoxVerdict SilhouettePyramid::ClassifyRectangle(double x0,
                                                double y0,
                                                double x1,
                                                double y1) const {
  const bool inside =
      x0 >= 0 && y0 >= 0 && x1 <= camera_.width && y1 <= camera_.height;
  const bool outside =
      x1 <= 0 || y1 <= 0 || x0 >= camera_.width || y0 >= camera_.height;
  if (outside) {
    return closed_ ? BoxVerdict::kBackground : BoxVerdict::kUnknown;
  }
  if (!inside && !closed_) {
    return BoxVerdict::kMixed;
  }
  // Every pixel that the rectangle touches.
  const int left = int(std::floor(std::max(x0, 0.0)));
  const int top = int(std::floor(std::max(y0, 0.0)));
  const int right = int(std::ceil(std::min(x1, double(camera_.width))));
  const int bottom = int(std::ceil(std::min(y1, double(camera_.height))));
  const int64_t count = Count(left, top, right, bottom);
  if (count == 0) {
    return BoxVerdict::kBackground;
  }
  const bool full = count == int64_t(right - left) * (bottom - top);
  return inside && full ? BoxVerdict::kObject : BoxVerdict::kMixed;
}

BoxVerdict SilhouettePyramid::Classify(const Eigen::AlignedBox3d& box) const {
  const Eigen::Vector3d center = box.center();
  const Eigen::Vector3d half = 0.5 * box.sizes();
  for (const Plane& plane : planes_) {
    const double reach = plane.normal.cwiseAbs().dot(half);
    if (plane.normal.dot(center) + plane.offset + reach < 0) {
      return BoxVerdict::kBackground;
    }
  }
  const Eigen::Vector3d center_in_cam = cam_from_world_ * center;
  const auto& rotation = cam_from_world_.rotation;
  const double reach_z = rotation.row(2).cwiseAbs().transpose().dot(half);
  if (center_in_cam.z() + reach_z <= 0) {
    return BoxVerdict::kUnknown;  // behind an open view
  }
  // A box that begins this near to the camera's plane has an unbounded or
  // useless footprint.
  if (center_in_cam.z() - reach_z <= 1e-3 * center_in_cam.z()) {
    return BoxVerdict::kMixed;
  }
  double x0 = std::numeric_limits<double>::infinity();
  double y0 = x0;
  double x1 = -x0;
  double y1 = -x0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d offset((corner & 1) ? half.x() : -half.x(),
                                 (corner & 2) ? half.y() : -half.y(),
                                 (corner & 4) ? half.z() : -half.z());
    const Eigen::Vector2d pixel =
        camera_.Project(center_in_cam + rotation * offset);
    x0 = std::min(x0, pixel.x());
    x1 = std::max(x1, pixel.x());
    y0 = std::min(y0, pixel.y());
    y1 = std::max(y1, pixel.y());
  }
  return ClassifyRectangle(x0, y0, x1, y1);
}

BoxVerdict SilhouettePyramid::Classify(const Eigen::Vector3d& point) const {
  const BoxVerdict out_of_sight =
      closed_ ? BoxVerdict::kBackground : BoxVerdict::kUnknown;
  const auto pixel = camera_.ProjectIntoFrame(cam_from_world_ * point);
  if (!pixel) {
    return out_of_sight;
  }
  const int x = int(pixel->x());
  const int y = int(pixel->y());
  return Count(x, y, x + 1, y + 1) > 0 ? BoxVerdict::kObject
                                       : BoxVerdict::kBackground;
}

}  // namespace octacut
