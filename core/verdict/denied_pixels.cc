#include "core/verdict/denied_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <Eigen/LU>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>

namespace octacut {
namespace {

// Pixels that are looked at, about: enough for a share.
constexpr double kMaxPixels = 200;
// Samples of a ray an edge of the root cube.
constexpr int kSamplesPerEdge = 128;
// More views than that are not likely to be wrong at the same point.
constexpr size_t kMaxBlamed = 2;

// The views that deny a point, in the order of their numbers.
using Denying = std::vector<size_t>;

class RayOfPixel {
 public:
  RayOfPixel(const ViewSet& views,
             const std::vector<double>& margins,
             size_t view)
      : views_(views), margins_(margins), view_(view) {}

  // The fewest that deny a point of the ray; none outside of the root cube.
  std::optional<Denying> FewestDenying(const Eigen::Vector3f& direction) const {
    const Eigen::Vector3f& center = views_[view_].projection.center;
    const float middle =
        direction.dot(Eigen::Vector3f::Constant(0.5f) - center);
    // Half the cube's diagonal is 0.866.
    constexpr int kReach = kSamplesPerEdge * 7 / 8;
    std::optional<Denying> fewest;
    for (int i = -kReach; i <= kReach && !(fewest && fewest->empty()); ++i) {
      const float depth = middle + float(i) / kSamplesPerEdge;
      const Eigen::Vector3f point = center + depth * direction;
      if (depth > 0 && point.minCoeff() >= 0 && point.maxCoeff() <= 1) {
        Denying denying = FindDenying(point);
        if (!fewest || denying.size() < fewest->size()) {
          fewest = std::move(denying);
        }
      }
    }
    return fewest;
  }

 private:
  Denying FindDenying(const Eigen::Vector3f& point) const {
    Denying denying;
    for (size_t i = 0; i < views_.size(); ++i) {
      const std::optional<ProjectedPoint> p =
          i == view_ ? std::nullopt : views_[i].projection.Project(point);
      if (p && views_[i].silhouette.SignedDistance(p->u, p->v) <
                   -float(margins_[i])) {
        denying.push_back(i);
      }
    }
    return denying;
  }

  const ViewSet& views_;
  const std::vector<double>& margins_;
  size_t view_;
};

}  // namespace

DeniedPixels FindDeniedPixels(const ViewSet& views,
                              const std::vector<double>& margins,
                              size_t view,
                              const cv::Mat& pixels) {
  DeniedPixels denied{0, std::vector<size_t>(views.size())};
  const int count = cv::countNonZero(pixels);
  const size_t stride =
      std::max<size_t>(1, size_t(std::lround(count / kMaxPixels)));
  const Eigen::Matrix3f unproject = views[view].projection.linear.inverse();
  const RayOfPixel ray(views, margins, view);
  size_t seen = 0;
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      if (pixels.at<uint8_t>(y, x) == 0 || seen++ % stride != 0) {
        continue;
      }
      const Eigen::Vector3f direction =
          unproject * Eigen::Vector3f(float(x) + 0.5f, float(y) + 0.5f, 1);
      const std::optional<Denying> denying =
          ray.FewestDenying(direction.normalized());
      denied.count += denying && denying->empty() ? 0 : stride;
      if (denying && denying->size() <= kMaxBlamed) {
        for (const size_t i : *denying) {
          denied.by_view[i] += stride;
        }
      }
    }
  }
  denied.count = std::min(denied.count, size_t(count));
  return denied;
}

}  // namespace octacut
