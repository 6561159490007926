#include "core/print/marker_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>
#include <map>
#include <numbers>
#include <optional>

#include "core/base/error.h"

namespace octacut {
namespace {

// Corners are found to a third of a pixel, so this is far off.
constexpr double kMaxResidual = 3;  // pixels
// Below, depth is more than 30 times less certain than what is across.
constexpr double kMinAngle = 2;  // degrees
// Weights of the rays follow from the point; it hardly moves after that.
constexpr int kIterations = 5;

using Sightings = std::vector<const MarkerSighting*>;

Eigen::Vector3d CenterOf(const MarkerSighting& view) {
  return view.cam_from_world.Inverse().translation;
}
Eigen::Vector3d WorldRay(const MarkerSighting& view, int corner) {
  return (view.cam_from_world.rotation.transpose() * view.rays[corner])
      .normalized();
}

// The point whose squared angles to the rays have the least sum.
Eigen::Vector3d TriangulateCorner(const Sightings& views, int corner) {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const MarkerSighting* view : views) {
      const Eigen::Vector3d center = CenterOf(*view);
      const Eigen::Vector3d ray = WorldRay(*view, corner);
      const double weight =
          iteration == 0 ? 1 : 1 / (point - center).squaredNorm();
      const Eigen::Matrix3d across =
          weight * (Eigen::Matrix3d::Identity() - ray * ray.transpose());
      normal += across;
      right += across * center;
    }
    point = normal.ldlt().solve(right);
  }
  return point;
}

// In pixels; infinite behind the camera.
double Residual(const MarkerSighting& view,
                int corner,
                const Eigen::Vector3d& point) {
  const Eigen::Vector3d in_cam = view.cam_from_world * point;
  const Eigen::Vector3d ray = view.rays[corner].normalized();
  const double along = in_cam.dot(ray);
  if (!(along > 0)) {
    return std::numeric_limits<double>::infinity();
  }
  return view.focal_length * (in_cam - along * ray).norm() / along;
}

double LargestAngle(const Sightings& views) {
  double least_cosine = 1;
  for (const MarkerSighting* a : views) {
    for (const MarkerSighting* b : views) {
      least_cosine =
          std::min(least_cosine, WorldRay(*a, 0).dot(WorldRay(*b, 0)));
    }
  }
  return std::acos(least_cosine) * 180 / std::numbers::pi;
}

// Removes views until the rest agree; nothing where fewer than two are left.
std::optional<MeasuredMarker> MeasureMarker(int id, Sightings* views) {
  while (views->size() >= 2 && LargestAngle(*views) >= kMinAngle) {
    MeasuredMarker marker{id, views->size(), 0, {}};
    for (int corner = 0; corner < 4; ++corner) {
      marker.corners[corner] = TriangulateCorner(*views, corner);
    }
    const auto worst_of = [&](const MarkerSighting* view) {
      double worst = 0;
      for (int corner = 0; corner < 4; ++corner) {
        worst =
            std::max(worst, Residual(*view, corner, marker.corners[corner]));
      }
      return worst;
    };
    const auto worst = std::max_element(
        views->begin(), views->end(), [&](const auto* a, const auto* b) {
          return worst_of(a) < worst_of(b);
        });
    if (worst_of(*worst) <= kMaxResidual) {
      for (int corner = 0; corner < 4; ++corner) {
        marker.side +=
            (marker.corners[(corner + 1) % 4] - marker.corners[corner]).norm() /
            4;
      }
      return marker;
    }
    views->erase(worst);
  }
  return std::nullopt;
}

void SummarizeSides(double side, MarkerScale* scale) {
  double sum = 0;
  for (const MeasuredMarker& marker : scale->markers) {
    for (int corner = 0; corner < 4; ++corner) {
      const double length =
          (marker.corners[(corner + 1) % 4] - marker.corners[corner]).norm();
      const double deviation = std::abs(scale->factor * length / side - 1);
      sum += deviation * deviation;
      scale->side_max = std::max(scale->side_max, deviation);
    }
  }
  scale->side_rms = std::sqrt(sum / (4 * double(scale->markers.size())));
}

}  // namespace

MarkerScale MeasureMarkerScale(const std::vector<MarkerSighting>& sightings,
                               double side) {
  std::map<int, Sightings> by_id;
  for (const MarkerSighting& sighting : sightings) {
    by_id[sighting.id].push_back(&sighting);
  }
  MarkerScale scale;
  double sum_of_sides = 0;
  double sum_of_squares = 0;
  size_t num_corners = 0;
  for (auto& [id, views] : by_id) {
    const auto marker = MeasureMarker(id, &views);
    if (!marker) {
      continue;
    }
    for (const MarkerSighting* view : views) {
      for (int corner = 0; corner < 4; ++corner) {
        const double residual =
            Residual(*view, corner, marker->corners[corner]);
        sum_of_squares += residual * residual;
        ++num_corners;
      }
    }
    sum_of_sides += marker->side;
    scale.markers.push_back(*marker);
  }
  if (scale.markers.empty()) {
    throw InputError(
        by_id.empty()
            ? "the photographs show no ArUco marker of this dictionary"
            : fmt::format(
                  "the photographs show {} different ArUco markers, but none "
                  "of them in two views that agree on where it is and whose "
                  "directions differ by {:g} degrees",
                  by_id.size(),
                  kMinAngle));
  }
  scale.factor = side * double(scale.markers.size()) / sum_of_sides;
  scale.reprojection_rms = std::sqrt(sum_of_squares / double(num_corners));
  SummarizeSides(side, &scale);
  return scale;
}

}  // namespace octacut
