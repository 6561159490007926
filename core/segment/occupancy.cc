#include "core/segment/occupancy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"

namespace octacut {
namespace {

// How often the ray through an empty point meets the object elsewhere. Points
// just outside of the object are what matters, where most rays do.
constexpr float kCoveredElsewhere = 0.7f;
// A point that fewer of the views show is not where they look.
constexpr double kMinShowing = 0.7;
// Voxels around the object that one view may add to it. What is farther away
// and only that view denies is something else.
constexpr size_t kNearObject = 3;
// A part that is severed, in sizes of the main component. Chance agreements of
// all views are smaller.
constexpr double kLeastPart = 0.01;
constexpr float kNoObject = -std::numeric_limits<float>::infinity();
constexpr float kLowest = -3 * kMaxViewLogOdds;
// Scores below this are below kLowest without any one view, too.
constexpr float kIgnored = kLowest - 2 * kMaxViewLogOdds;

// Evidence for a point on the ray of a pixel with these log odds.
float EvidenceOf(float log_odds) {
  return std::max(-kMaxViewLogOdds,
                  -std::log(kCoveredElsewhere +
                            (1 - kCoveredElsewhere) * std::exp(-log_odds)));
}

Pose Scaled(const Pose& pose, const cv::Size& size) {
  Pose scaled = pose;
  const double x = double(size.width) / pose.camera.width;
  const double y = double(size.height) / pose.camera.height;
  scaled.camera.width = size.width;
  scaled.camera.height = size.height;
  scaled.camera.fx *= x;
  scaled.camera.cx *= x;
  scaled.camera.fy *= y;
  scaled.camera.cy *= y;
  return scaled;
}

// The size of a picture whose pixels are as wide as voxels at the centre.
cv::Size SizeForVoxels(const Pose& pose, const BoundingCube& cube, int n) {
  const double depth =
      std::max((pose.cam_from_world * cube.Center()).z(), cube.edge / n);
  const double pixels = pose.camera.fx * (cube.edge / n) / depth;
  const double factor = 1 / std::max(1.0, pixels);
  return {std::max(1, int(std::lround(pose.camera.width * factor))),
          std::max(1, int(std::lround(pose.camera.height * factor)))};
}

}  // namespace

// Projection of many points with one camera, in single precision. The points
// are relative to `origin`, so that the scale of the world does not matter.
class OccupancyGrid::PointProjector {
 public:
  PointProjector(const Pose& pose, const Eigen::Vector3d& origin) {
    Eigen::Matrix3d k = Eigen::Matrix3d::Identity();
    k(0, 0) = pose.camera.fx;
    k(1, 1) = pose.camera.fy;
    k(0, 2) = pose.camera.cx;
    k(1, 2) = pose.camera.cy;
    rotation_ = (k * pose.cam_from_world.rotation).cast<float>();
    translation_ = (k * (pose.cam_from_world * origin)).cast<float>();
    width_ = float(pose.camera.width);
    height_ = float(pose.camera.height);
  }
  // False where the frame does not show the point.
  bool Project(const Eigen::Vector3f& point, float* x, float* y) const {
    const Eigen::Vector3f p = rotation_ * point + translation_;
    *x = p.x() / p.z();
    *y = p.y() / p.z();
    return p.z() > 0 && *x >= 0 && *y >= 0 && *x < width_ && *y < height_;
  }

 private:
  Eigen::Matrix3f rotation_;
  Eigen::Vector3f translation_;
  float width_;
  float height_;
};

OccupancyGrid::OccupancyGrid(const BoundingCube& cube,
                             int resolution,
                             const SearchBounds& bounds,
                             std::span<const Pose> poses,
                             std::span<const cv::Mat> log_odds,
                             const Context& context)
    : cube_(cube),
      resolution_(resolution),
      views_(poses.size()),
      scores_(size_t(resolution) * size_t(resolution) * size_t(resolution)) {
  for (const Pose& pose : poses) {
    sizes_.emplace_back(pose.camera.width, pose.camera.height);
  }
  ParallelEach(context, poses.size(), 1, [&](size_t i) {
    const cv::Size size = SizeForVoxels(poses[i], cube, resolution);
    views_[i].pose = Scaled(poses[i], size);
    cv::resize(log_odds[i], views_[i].evidence, size, 0, 0, cv::INTER_AREA);
    for (float& value : cv::Mat_<float>(views_[i].evidence)) {
      value = EvidenceOf(value);
    }
  });
  ParallelEach(context, size_t(resolution), 1, [&](size_t z) {
    AddSlice(int(z), bounds);
  });
}

Eigen::Vector3d OccupancyGrid::CenterOf(int x, int y, int z) const {
  return cube_.min_corner + OffsetOf(x, y, z);
}

Eigen::Vector3d OccupancyGrid::OffsetOf(int x, int y, int z) const {
  return Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5) *
         (cube_.edge / resolution_);
}

float OccupancyGrid::ScoreOf(const Eigen::Vector3f& offset,
                             std::span<const PointProjector> projectors,
                             bool is_allowed) const {
  static const float kMost = LogOddsOfSure(1);
  float sum = 0;
  size_t num_showing = 0;
  for (size_t i = 0; i < views_.size(); ++i) {
    float u = 0;
    float v = 0;
    if (projectors[i].Project(offset, &u, &v)) {
      sum += views_[i].evidence.at<float>(int(v), int(u));
      ++num_showing;
    }
    if (sum + kMost * float(views_.size() - i) < kIgnored) {
      return kNoObject;
    }
  }
  is_allowed |= double(num_showing) >= kMinShowing * double(views_.size());
  return is_allowed ? sum : kNoObject;
}

void OccupancyGrid::AddSlice(int z, const SearchBounds& bounds) {
  std::vector<PointProjector> projectors;
  for (const EvidenceView& view : views_) {
    projectors.emplace_back(view.pose, cube_.min_corner);
  }
  for (int y = 0; y < resolution_; ++y) {
    for (int x = 0; x < resolution_; ++x) {
      scores_[IndexOf(x, y, z)] = bounds.Contain(CenterOf(x, y, z))
                                      ? ScoreOf(OffsetOf(x, y, z).cast<float>(),
                                                projectors,
                                                bounds.box.has_value())
                                      : kNoObject;
    }
  }
}

std::vector<int> OccupancyGrid::LabelComponents(int* num_components) const {
  const int n = resolution_;
  std::vector<int> component_of(scores_.size(), -1);
  std::vector<std::array<int, 3>> stack;
  *num_components = 0;
  const auto visit = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= n || y >= n || z >= n) {
      return;
    }
    const size_t i = IndexOf(x, y, z);
    if (scores_[i] > 0 && component_of[i] < 0) {
      component_of[i] = *num_components;
      stack.push_back({x, y, z});
    }
  };
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        visit(x, y, z);
        if (stack.empty()) {
          continue;
        }
        while (!stack.empty()) {
          const auto [a, b, c] = stack.back();
          stack.pop_back();
          visit(a - 1, b, c);
          visit(a + 1, b, c);
          visit(a, b - 1, c);
          visit(a, b + 1, c);
          visit(a, b, c - 1);
          visit(a, b, c + 1);
        }
        ++*num_components;
      }
    }
  }
  return component_of;
}

bool OccupancyGrid::KeepMainComponent(const Eigen::Vector3d& center,
                                      double radius,
                                      bool keeps_parts) {
  int num_components = 0;
  const std::vector<int> component_of = LabelComponents(&num_components);
  if (num_components == 0) {
    return false;
  }
  std::vector<double> weights(num_components);
  std::vector<size_t> sizes(num_components);
  for (int z = 0; z < resolution_; ++z) {
    for (int y = 0; y < resolution_; ++y) {
      for (int x = 0; x < resolution_; ++x) {
        const int component = component_of[IndexOf(x, y, z)];
        if (component >= 0) {
          const double distance = (CenterOf(x, y, z) - center).norm() / radius;
          weights[component] += std::exp(-distance * distance);
          ++sizes[component];
        }
      }
    }
  }
  const auto kept = std::max_element(weights.begin(), weights.end());
  const size_t size = sizes[kept - weights.begin()];
  const auto is_kept = [&](int component) {
    return component == kept - weights.begin() ||
           (keeps_parts &&
            kLeastPart * double(size) <= double(sizes[component]));
  };
  std::vector<uint8_t> near(scores_.size());
  for (size_t i = 0; i < scores_.size(); ++i) {
    near[i] = component_of[i] >= 0 && is_kept(component_of[i]);
  }
  Grow(&near);
  for (size_t i = 0; i < scores_.size(); ++i) {
    if (!near[i] || (component_of[i] >= 0 && !is_kept(component_of[i]))) {
      scores_[i] = kNoObject;
    }
  }
  return true;
}

void OccupancyGrid::Grow(std::vector<uint8_t>* flags) const {
  const size_t n = size_t(resolution_);
  for (const size_t step : {size_t{1}, n, n * n}) {  // x, y and z
    const std::vector<uint8_t> before = *flags;
    for (size_t i = 0; i < before.size(); ++i) {
      if (before[i] == 0) {
        continue;
      }
      const size_t point = i / step % n;
      const size_t down = std::min(point, kNearObject);
      const size_t up = std::min(n - 1 - point, kNearObject);
      for (size_t k = 0; k <= down + up; ++k) {
        (*flags)[i - down * step + k * step] = 1;
      }
    }
  }
}

Eigen::AlignedBox3d OccupancyGrid::ObjectBox() const {
  Eigen::AlignedBox3d box;
  const Eigen::Vector3d half =
      Eigen::Vector3d::Constant(cube_.edge / resolution_ / 2);
  for (int z = 0; z < resolution_; ++z) {
    for (int y = 0; y < resolution_; ++y) {
      for (int x = 0; x < resolution_; ++x) {
        if (scores_[IndexOf(x, y, z)] > 0) {
          box.extend(CenterOf(x, y, z) - half);
          box.extend(CenterOf(x, y, z) + half);
        }
      }
    }
  }
  return box;
}

float OccupancyGrid::LogOddsOfSure(size_t num_others) {
  return float(num_others) * EvidenceOf(std::numeric_limits<float>::infinity());
}

cv::Mat OccupancyGrid::LogOddsOfOthers(size_t view) const {
  const EvidenceView& own = views_[view];
  const PointProjector projector(own.pose, cube_.min_corner);
  const cv::Size size = own.evidence.size();
  cv::Mat log_odds(size, CV_32F, cv::Scalar(kLowest));
  for (int z = 0; z < resolution_; ++z) {
    for (int y = 0; y < resolution_; ++y) {
      for (int x = 0; x < resolution_; ++x) {
        const float score = scores_[IndexOf(x, y, z)];
        float u = 0;
        float v = 0;
        if (score < kIgnored ||
            !projector.Project(OffsetOf(x, y, z).cast<float>(), &u, &v)) {
          continue;
        }
        const float others = score - own.evidence.at<float>(int(v), int(u));
        // A voxel is about a pixel wide and reaches into the nearest four.
        const int left = int(std::floor(u - 0.5f));
        const int top = int(std::floor(v - 0.5f));
        for (int row = std::max(0, top);
             row <= std::min(top + 1, size.height - 1);
             ++row) {
          for (int column = std::max(0, left);
               column <= std::min(left + 1, size.width - 1);
               ++column) {
            float& value = log_odds.at<float>(row, column);
            value = std::max(value, others);
          }
        }
      }
    }
  }
  cv::Mat result;
  cv::resize(log_odds, result, sizes_[view], 0, 0, cv::INTER_LINEAR);
  return result;
}

}  // namespace octacut
