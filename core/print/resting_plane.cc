#include "core/print/resting_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/mesh/bounding_box.h"
#include "core/raycast/ray_scene.h"

namespace octacut {
namespace {

// As fractions of the diagonal: how far around the object points count, how
// close to it they are its own, how well the object must stand on the plane.
constexpr double kReach = 2;
constexpr double kOwnDistance = 0.01;
constexpr double kMaxGap = 0.1;
// Bounds of the distance up to which a point is on a plane; in between, three
// times the noise decides.
constexpr double kMinTolerance = 0.001;
constexpr double kMaxTolerance = 0.01;
// Fewer may be on a plane by chance.
constexpr size_t kMinPoints = 20;
constexpr size_t kPointDivisor = 10;  // one of so many candidates
// If a tenth of the points are on the plane, three of them are all on it in one
// of 1000 trials: 4000 miss it once in 50 runs, and one with a fifth never.
constexpr uint64_t kTrials = 4000;
// The plane is fitted anew to the points that are on it.
constexpr int kFits = 5;
// So many vertices of the mesh bound its lowest point well enough for kMaxGap.
constexpr size_t kMaxVertices = 2000;

struct Plane {
  Eigen::Vector3d up;
  double offset;

  double Height(const Eigen::Vector3d& point) const {
    return up.dot(point) - offset;
  }
};

double LeastHeight(const Plane& plane,
                   const std::vector<Eigen::Vector3d>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : points) {
    least = std::min(least, plane.Height(point));
  }
  return least;
}

class StandSearch {
 public:
  StandSearch(const IndexedMesh& mesh, const Surroundings& surroundings)
      : surroundings_(surroundings) {
    const Eigen::AlignedBox3d box = BoundingBox(mesh);
    center_ = box.center();
    diagonal_ = box.diagonal().norm();
    tolerance_ = std::clamp(3 * surroundings.noise,
                            kMinTolerance * diagonal_,
                            kMaxTolerance * diagonal_);
    const size_t stride = mesh.positions.size() / kMaxVertices + 1;
    for (size_t v = 0; v < mesh.positions.size(); v += stride) {
      vertices_.push_back(mesh.positions[v]);
    }
    const RayScene scene(mesh);
    const double own =
        std::max(3 * surroundings.noise, kOwnDistance * diagonal_);
    for (const Eigen::Vector3d& point : surroundings.points) {
      if ((point - center_).norm() <= kReach * diagonal_ &&
          scene.ClosestPoint(point).distance > own) {
        candidates_.push_back(point);
      }
    }
  }

  size_t NumCandidates() const { return candidates_.size(); }
  size_t LeastPoints() const {
    return std::max(kMinPoints, candidates_.size() / kPointDivisor);
  }
  // From the plane to the lowest of some vertices.
  double Gap(const Plane& plane) const { return LeastHeight(plane, vertices_); }

  std::vector<Eigen::Vector3d> PointsOn(const Plane& plane) const {
    std::vector<Eigen::Vector3d> points;
    std::copy_if(
        candidates_.begin(),
        candidates_.end(),
        std::back_inserter(points),
        [&](const Eigen::Vector3d& point) { return IsOn(plane, point); });
    return points;
  }

  std::optional<Plane> Search(const Context& context) const {
    std::optional<Plane> best;
    size_t most = LeastPoints() - 1;
    for (uint64_t trial = 0; trial < kTrials && candidates_.size() >= 3;
         ++trial) {
      context.ThrowIfCancelled();
      const auto pick = [&](uint64_t i) -> const Eigen::Vector3d& {
        return candidates_[HashBits(context.Seed(), trial, i) %
                           candidates_.size()];
      };
      const Eigen::Vector3d normal =
          (pick(1) - pick(0)).cross(pick(2) - pick(0));
      if (!(normal.norm() > 0)) {
        continue;
      }
      const Plane plane = TowardsObject(normal.normalized(), pick(0));
      if (!MayBeStand(plane)) {
        continue;
      }
      const auto count = size_t(std::count_if(
          candidates_.begin(),
          candidates_.end(),
          [&](const Eigen::Vector3d& point) { return IsOn(plane, point); }));
      if (count > most) {
        most = count;
        best = plane;
      }
    }
    return best;
  }

  // Through the centre of the points, across their least spread.
  Plane Fit(const std::vector<Eigen::Vector3d>& points) const {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) {
      mean += point / double(points.size());
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& point : points) {
      spread += (point - mean) * (point - mean).transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    return TowardsObject(solver.eigenvectors().col(0), mean);
  }

 private:
  bool IsOn(const Plane& plane, const Eigen::Vector3d& point) const {
    return std::abs(plane.Height(point)) <= tolerance_;
  }

  Plane TowardsObject(const Eigen::Vector3d& normal,
                      const Eigen::Vector3d& point) const {
    const double sign = normal.dot(center_ - point) < 0 ? -1 : 1;
    return {sign * normal, sign * normal.dot(point)};
  }

  bool MayBeStand(const Plane& plane) const {
    if (std::abs(Gap(plane)) > kMaxGap * diagonal_) {
      return false;
    }
    const auto& centers = surroundings_.camera_centers;
    const auto above = std::count_if(
        centers.begin(), centers.end(), [&](const Eigen::Vector3d& center) {
          return plane.Height(center) > 0;
        });
    return 2 * size_t(above) >= centers.size();
  }

  const Surroundings& surroundings_;
  Eigen::Vector3d center_;
  double diagonal_ = 0;
  double tolerance_ = 0;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Eigen::Vector3d> candidates_;
};

}  // namespace

RestingPlane FindRestingPlane(const IndexedMesh& mesh,
                              const Surroundings& surroundings,
                              const Context& context) {
  const Phase phase(context, "stand");
  const StandSearch search(mesh, surroundings);
  std::optional<Plane> plane = search.Search(context);
  if (!plane) {
    throw InputError(fmt::format(
        "no plane that the object stands on was found: of {} sparse points "
        "around it, no {} lie in a plane at its lowest point; give the "
        "direction as `up` x,y,z",
        search.NumCandidates(),
        search.LeastPoints()));
  }
  for (int i = 0; i < kFits; ++i) {
    plane = search.Fit(search.PointsOn(*plane));
  }
  RestingPlane stand;
  stand.up = plane->up;
  stand.offset = plane->offset;
  stand.num_candidates = search.NumCandidates();
  const std::vector<Eigen::Vector3d> points = search.PointsOn(*plane);
  stand.num_points = points.size();
  double sum = 0;
  for (const Eigen::Vector3d& point : points) {
    sum += plane->Height(point) * plane->Height(point);
  }
  stand.rms = std::sqrt(sum / double(std::max<size_t>(points.size(), 1)));
  stand.gap = LeastHeight(*plane, mesh.positions);
  return stand;
}

}  // namespace octacut
