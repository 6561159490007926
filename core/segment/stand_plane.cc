#include "core/segment/stand_plane.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/hash.h"
#include "core/base/median.h"

namespace octacut {
namespace {

using Plane = Eigen::Hyperplane<double, 3>;

constexpr size_t kMinPoints = 30;
// More points than these are thinned out.
constexpr size_t kMaxPoints = 10000;
// With so many tries, a plane with a twentieth of the points is found with more
// than 99 % certainty. A plate that the cameras see from low above has hardly
// more beside an object with much texture.
constexpr int kTries = 40000;
constexpr double kLeastShareOfPoints = 0.05;
constexpr double kReach = 2;  // radii of the region
// Part of the cameras above, and of the points that may be below.
constexpr double kMostCameras = 0.9;
constexpr double kMostBelow = 0.03;
// Tolerances below the plane from which on a point is below, and not noise.
constexpr double kClearlyBelow = 4;
constexpr int kRefinements = 3;

class PlaneFinder {
 public:
  PlaneFinder(std::span<const Eigen::Vector3d> points,
              std::span<const Pose> poses,
              const SearchRegion& region)
      : region_(region) {
    std::vector<Eigen::Vector3d> near;
    for (const Eigen::Vector3d& point : points) {
      if ((point - region.center).norm() < kReach * region.radius) {
        near.push_back(point);
      }
    }
    const size_t step = near.size() / kMaxPoints + 1;
    for (size_t i = 0; i < near.size(); i += step) {
      points_.push_back(near[i]);
    }
    std::vector<double> sizes;
    for (const Pose& pose : poses) {
      cameras_.push_back(pose.cam_from_world.Inverse().translation);
      sizes.push_back((cameras_.back() - region.center).norm() /
                      pose.camera.fx);
    }
    tolerance_ = Median(std::move(sizes));
  }

  std::optional<StandPlane> Find() {
    if (points_.size() < kMinPoints) {
      return {};
    }
    std::optional<Plane> best;
    size_t most = 0;
    for (int i = 0; i < kTries; ++i) {
      if (const std::optional<Plane> plane = PlaneOfThree(uint64_t(i))) {
        // The cheap test first.
        if (!IsBelowCameras(*plane)) {
          continue;
        }
        const size_t count = CountOn(*plane);
        if (count > most && IsBelowPoints(*plane)) {
          most = count;
          best = plane;
        }
      }
    }
    if (!best || double(most) < kLeastShareOfPoints * double(points_.size())) {
      return {};
    }
    for (int i = 0; i < kRefinements; ++i) {
      best = Refined(*best);
    }
    return StandPlane{*best, tolerance_};
  }

 private:
  // Cameras and object above.
  Plane Oriented(Plane plane) const {
    if (plane.signedDistance(region_.center) < 0) {
      plane.coeffs() = -plane.coeffs();
    }
    return plane;
  }
  std::optional<Plane> PlaneOfThree(uint64_t bits) const {
    const auto pick = [&](uint64_t k) -> const Eigen::Vector3d& {
      return points_[HashBits(bits, k) % points_.size()];
    };
    const Eigen::Vector3d& a = pick(0);
    const Eigen::Vector3d u = pick(1) - a;
    const Eigen::Vector3d v = pick(2) - a;
    const Eigen::Vector3d normal = u.cross(v);
    // Three points nearly in a line, or near each other, say nothing.
    if (normal.norm() < 0.05 * region_.radius * region_.radius) {
      return {};
    }
    return Oriented(Plane(normal.normalized(), a));
  }
  size_t CountOn(const Plane& plane) const {
    return size_t(
        std::count_if(points_.begin(), points_.end(), [&](const auto& point) {
          return std::abs(plane.signedDistance(point)) < tolerance_;
        }));
  }
  bool IsBelowCameras(const Plane& plane) const {
    const auto num_above = double(std::count_if(
        cameras_.begin(), cameras_.end(), [&](const auto& camera) {
          return plane.signedDistance(camera) > 0;
        }));
    return num_above >= kMostCameras * double(cameras_.size());
  }
  bool IsBelowPoints(const Plane& plane) const {
    const auto num_below = double(
        std::count_if(points_.begin(), points_.end(), [&](const auto& point) {
          return plane.signedDistance(point) < -kClearlyBelow * tolerance_;
        }));
    return num_below <= kMostBelow * double(points_.size());
  }
  // Least squares over the points on it.
  Plane Refined(const Plane& plane) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    double count = 0;
    for (const Eigen::Vector3d& point : points_) {
      if (std::abs(plane.signedDistance(point)) < tolerance_) {
        const Eigen::Vector3d offset = point - region_.center;
        sum += offset;
        products += offset * offset.transpose();
        ++count;
      }
    }
    const Eigen::Vector3d mean = sum / count;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
        products / count - mean * mean.transpose());
    return Oriented(Plane(eigen.eigenvectors().col(0), region_.center + mean));
  }

  const SearchRegion& region_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Eigen::Vector3d> cameras_;
  double tolerance_ = 0;
};

}  // namespace

std::optional<StandPlane> FindStandPlane(
    std::span<const Eigen::Vector3d> points,
    std::span<const Pose> poses,
    const SearchRegion& region) {
  return PlaneFinder(points, poses, region).Find();
}

}  // namespace octacut
