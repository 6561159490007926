#include "core/verdict/surface_support.h"

#include <cmath>
#include <limits>

namespace octacut {
namespace {

// Pixels; a precision is one over a standard deviation.
constexpr float kMaxOffset = 1;
constexpr float kMinPrecision = 1;
constexpr float kNearHull = 1.5f;
// Cosine of the angle to the normal from which on a view faces a point: 70
// degrees, as visibility has it.
constexpr float kFacing = 0.34f;
// Sine of 30 degrees.
constexpr float kAbove = 0.5f;
// Mean of the images' unit vectors up, below whose length they have no common
// one.
constexpr double kCommonUp = 0.5;

std::optional<Eigen::Vector3f> CommonUp(const std::vector<View>& views) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const View& view : views) {
    sum -= view.cam_from_world.rotation.row(1).transpose();
  }
  if (sum.norm() < kCommonUp * double(views.size())) {
    return std::nullopt;
  }
  return sum.normalized().cast<float>();
}

bool IsHidden(const PointEvidence& point, const ViewSet& views) {
  int num_facing = 0;
  for (const PreparedView& view : views) {
    const Eigen::Vector3f direction =
        (view.projection.center - point.position).normalized();
    num_facing += direction.dot(point.normal) > kFacing &&
                  view.projection.ProjectIntoFrame(point.position);
  }
  return num_facing >= 2;
}

size_t NearestView(const ViewSet& views, const Eigen::Vector3f& direction) {
  size_t nearest = 0;
  float best = -std::numeric_limits<float>::infinity();
  for (size_t i = 0; i < views.size(); ++i) {
    const Eigen::Vector3f from_middle =
        views[i].projection.center - Eigen::Vector3f::Constant(0.5f);
    const float cosine = from_middle.normalized().dot(direction);
    if (cosine > best) {
      best = cosine;
      nearest = i;
    }
  }
  return nearest;
}

BlindPart SumUpBlind(const std::vector<PointEvidence>& points,
                     const std::vector<View>& views,
                     const ViewSet& prepared,
                     double area) {
  BlindPart blind;
  const std::optional<Eigen::Vector3f> up = CommonUp(views);
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();
  for (const PointEvidence& point : points) {
    if (point.num_views >= 2) {
      continue;
    }
    const double share = point.area / area;
    blind.share += share;
    if (IsHidden(point, prepared)) {
      blind.hidden += share;
      continue;
    }
    normals += share * point.normal.cast<double>();
    if (up) {
      const float height = point.normal.dot(*up);
      (height > kAbove    ? blind.above
       : height < -kAbove ? blind.below
                          : blind.aside) += share;
    }
  }
  if (blind.share > blind.hidden && normals.norm() > 0) {
    blind.nearest_view =
        NearestView(prepared, normals.normalized().cast<float>());
  }
  return blind;
}

}  // namespace

Support SupportOf(const PointEvidence& point) {
  if (point.precision >= kMinPrecision &&
      std::abs(point.offset) <= kMaxOffset) {
    return Support::kPhotographs;
  }
  return IsNearHull(point) ? Support::kSilhouettes : Support::kNothing;
}

bool IsNearHull(const PointEvidence& point) {
  return point.hull_distance <= kNearHull;
}

SurfaceSupport SumUpSupport(const std::vector<PointEvidence>& points,
                            const std::vector<View>& views,
                            const ViewSet& prepared) {
  double area = 0;
  double measured = 0;
  double agreement = 0;
  SurfaceSupport support;
  for (const PointEvidence& point : points) {
    area += point.area;
    if (point.agreement) {
      measured += point.area;
      agreement += point.area * *point.agreement;
    }
    switch (SupportOf(point)) {
      case Support::kPhotographs:
        support.photographs += point.area;
        break;
      case Support::kSilhouettes:
        support.silhouettes += point.area;
        break;
      case Support::kNothing:
        support.nothing += point.area;
        break;
    }
  }
  if (!(area > 0)) {
    return support;
  }
  support.photographs /= area;
  support.silhouettes /= area;
  support.nothing /= area;
  support.agreement = measured > 0 ? agreement / measured : 0;
  support.blind = SumUpBlind(points, views, prepared, area);
  return support;
}

}  // namespace octacut
