#include "core/refine/contour_targets.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/median.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr float kProbeStep = 0.5f;  // pixels
constexpr float kBeside = 1;        // pixels
// Cosine of the largest angle to the line of sight, 45 degrees.
constexpr float kAlongSight = 0.7f;

// Pixels from (u, v) along `direction` to the border of the mask: where the
// coverage falls through one half, if it does so once within the range.
std::optional<float> FindBorder(const PreparedView& view,
                                const Eigen::Vector2f& pixel,
                                const Eigen::Vector2f& direction,
                                float range) {
  std::optional<float> border;
  const auto coverage = [&](float at) {
    const Eigen::Vector2f probe = pixel + at * direction;
    return view.silhouette.Coverage(probe.x(), probe.y());
  };
  if (!view.projection.InFrame(pixel.x() + range * direction.x(),
                               pixel.y() + range * direction.y())) {
    return std::nullopt;
  }
  float before = coverage(-range);
  if (before < kObjectCoverage) {
    return std::nullopt;
  }
  const int num_steps = int(2 * range / kProbeStep);
  for (int i = 1; i <= num_steps; ++i) {
    const float at = float(i) * kProbeStep - range;
    const float after = coverage(at);
    if ((before < kObjectCoverage) != (after < kObjectCoverage)) {
      if (border) {
        return std::nullopt;
      }
      border = at - kProbeStep * (kObjectCoverage - after) / (before - after);
    }
    before = after;
  }
  return border;
}

class ContourFinder {
 public:
  ContourFinder(const PreparedView& view,
                const RayScene& rays,
                const std::vector<LocalSurface>& surfaces,
                const VertexCorners& neighbors,
                float range,
                float border_shift)
      : view_(view),
        rays_(rays),
        surfaces_(surfaces),
        neighbors_(neighbors),
        range_(range),
        border_shift_(border_shift) {}

  float Facing(uint32_t vertex) const {
    return surfaces_[vertex].normal.dot(view_.projection.center -
                                        surfaces_[vertex].center);
  }

  // The target on an edge between two vertices that face to different sides.
  std::optional<ContourTarget> Find(uint32_t a, uint32_t b) const {
    const float facing_a = Facing(a);
    const float fraction = facing_a / (facing_a - Facing(b));
    const auto between = [&](const Eigen::Vector3f& from,
                             const Eigen::Vector3f& to) {
      return Eigen::Vector3f(from + fraction * (to - from));
    };
    const Eigen::Vector3f point =
        between(surfaces_[a].center, surfaces_[b].center);
    const Eigen::Vector3f normal =
        between(surfaces_[a].normal, surfaces_[b].normal).normalized();
    const ViewProjection& projection = view_.projection;
    const Eigen::Vector3f h = projection.Homogeneous(point);
    if (!(h.z() > 0)) {
      return std::nullopt;
    }
    const Eigen::Vector2f pixel = h.head<2>() / h.z();
    const Eigen::Vector3f step = projection.linear * normal;
    // Pixels by which a unit of offset moves the point.
    const Eigen::Vector2f motion = (step.head<2>() - pixel * step.z()) / h.z();
    const float speed = motion.norm();
    if (!projection.InFrame(pixel.x(), pixel.y()) || !(speed > 0)) {
      return std::nullopt;
    }
    const Eigen::Vector2f outward = motion / speed;
    const std::optional<float> border =
        FindBorder(view_, pixel + border_shift_ * outward, outward, range_);
    if (!border || !IsOutermost(point + kBeside / speed * normal)) {
      return std::nullopt;
    }
    const float beyond = std::max(Beyond(a, point, pixel, outward),
                                  Beyond(b, point, pixel, outward));
    return ContourTarget{{{a, b}, fraction, (*border - beyond) / speed, 1},
                         speed};
  }

 private:
  // Pixels by which neighbours of the vertex lie outside of the point, before
  // or behind it; 0 if none does. Where normals are noisy, edges beside the
  // contour change sides, too, and the outline lies as far outside of them.
  // Neighbours to the sides are outside wherever the outline is concave.
  float Beyond(uint32_t vertex,
               const Eigen::Vector3f& point,
               const Eigen::Vector2f& pixel,
               const Eigen::Vector2f& outward) const {
    const ViewProjection& projection = view_.projection;
    const Eigen::Vector3f sight = (point - projection.center).normalized();
    float beyond = 0;
    for (const uint32_t neighbor : neighbors_.Of(vertex)) {
      const Eigen::Vector3f& center = surfaces_[neighbor].center;
      const Eigen::Vector3f way = center - point;
      const Eigen::Vector3f h = projection.Homogeneous(center);
      if (h.z() > 0 && std::abs(way.dot(sight)) > kAlongSight * way.norm()) {
        beyond = std::max(beyond, (h.head<2>() / h.z() - pixel).dot(outward));
      }
    }
    return beyond;
  }

  // Whether the mesh ends here in the view: a line of sight just beside the
  // point misses all of it. A fold before the object is no occluding contour.
  bool IsOutermost(const Eigen::Vector3f& beside) const {
    return !rays_.IsOccluded(view_.projection.center.cast<double>(),
                             (beside - view_.projection.center).cast<double>(),
                             0,
                             std::numeric_limits<double>::infinity());
  }

  const PreparedView& view_;
  const RayScene& rays_;
  const std::vector<LocalSurface>& surfaces_;
  const VertexCorners& neighbors_;
  float range_;
  float border_shift_;
};

}  // namespace

std::vector<ContourTarget> FindContourTargets(
    const ViewSet& views,
    const RayScene& rays,
    const std::vector<LocalSurface>& surfaces,
    const VertexCorners& neighbors,
    const ContourSearch& search,
    const Context& context) {
  std::vector<std::vector<ContourTarget>> of_views(views.size());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    const ContourFinder finder(views[i],
                               rays,
                               surfaces,
                               neighbors,
                               float(search.range),
                               float(search.border_shift));
    for (uint32_t a = 0; a < surfaces.size(); ++a) {
      const bool is_front = finder.Facing(a) > 0;
      for (const uint32_t b : neighbors.Of(a)) {
        if (a < b && is_front != (finder.Facing(b) > 0)) {
          if (const auto target = finder.Find(a, b)) {
            of_views[i].push_back(*target);
          }
        }
      }
    }
  });
  std::vector<ContourTarget> targets;
  for (const std::vector<ContourTarget>& of_view : of_views) {
    targets.insert(targets.end(), of_view.begin(), of_view.end());
  }
  return targets;
}

std::optional<double> MedianDistance(
    const std::vector<ContourTarget>& contours) {
  if (contours.empty()) {
    return std::nullopt;
  }
  std::vector<float> distances;
  distances.reserve(contours.size());
  for (const ContourTarget& contour : contours) {
    distances.push_back(
        std::abs(contour.edge.target * contour.pixels_per_unit));
  }
  return Median(std::move(distances));
}

}  // namespace octacut
