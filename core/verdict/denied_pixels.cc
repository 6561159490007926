#include "core/verdict/denied_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>

#include "core/views/line_of_sight.h"

namespace octacut {
namespace {

// Pixels that are looked at, about: enough for a share.
constexpr double kMaxPixels = 200;
// Points of a ray an edge of the root cube.
constexpr int kPointsPerEdge = 128;
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
    std::optional<Denying> fewest;
    for (const Eigen::Vector3f& point : PointsOnLine(
             views_[view_].projection.center, direction, kPointsPerEdge)) {
      Denying denying = FindDenying(point);
      if (!fewest || denying.size() < fewest->size()) {
        fewest = std::move(denying);
      }
      if (fewest->empty()) {
        break;
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
  const Eigen::Matrix3f unproject = views[view].projection.RaysOfPixels();
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
