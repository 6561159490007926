#include "core/benchmark/protocols/eth3d.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/benchmark/protocols/point_tree.h"
#include "core/benchmark/protocols/surface_points.h"

namespace octacut {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kCellSize = 0.01;  // metres
constexpr double kBeamStartRadius = 0.5 * 0.00225;
constexpr double kBeamHalfAngle = 0.011;  // degrees
constexpr double kRadiansPerDegree = 0.017453292519943295;
constexpr size_t kCellGrain = 1024;

// From the tolerance of index `first_accurate` on, a point is accurate; below,
// it is inaccurate or not observed.
struct PointClass {
  size_t first_accurate = 0;
  bool inaccurate = false;
};

// The rays of a scan, found by their directions.
class ScanRays {
 public:
  explicit ScanRays(const LaserScan& scan)
      : scan_from_world_(scan.world_from_scan.Inverse()),
        points_(PointsOffOrigin(scan)),
        directions_(Directions(points_)) {}

  void Classify(const Eigen::Vector3d& world_point,
                const std::vector<double>& tolerances,
                PointClass* result) const {
    const Eigen::Vector3d point = scan_from_world_ * world_point;
    const double range = point.norm();
    const double beam =
        kBeamStartRadius + range * std::tan(kBeamHalfAngle * kRadiansPerDegree);
    // Rays at `beam` or less from the point make at most this angle with it;
    // the chord between their unit directions follows.
    const double angle =
        beam < range ? std::asin(beam / range) : 90 * kRadiansPerDegree;
    const Eigen::Vector3d direction = point.stableNormalized();
    for (const size_t i :
         directions_.FindWithin(direction, 2 * std::sin(angle / 2))) {
      const double distance = (points_[i] - point).norm();
      const auto first = static_cast<size_t>(
          std::lower_bound(tolerances.begin(), tolerances.end(), distance) -
          tolerances.begin());
      result->first_accurate = std::min(result->first_accurate, first);
      if (directions_.Points()[i].dot(point) < points_[i].norm()) {
        result->inaccurate = true;
      }
    }
  }

 private:
  static Points PointsOffOrigin(const LaserScan& scan) {
    Points points = scan.points;
    std::erase_if(points, [](const Eigen::Vector3d& p) { return p.isZero(0); });
    return points;
  }
  static Points Directions(Points points) {
    for (Eigen::Vector3d& point : points) {
      point.stableNormalize();
    }
    return points;
  }

  Rigid3d scan_from_world_;
  Points points_;
  PointTree directions_;
};

// The mean over all cells of both grids of the fraction of their points that
// are `good` among those that count; 0 where none does.
double MeanOverCells(
    const std::vector<std::vector<std::pair<CellKey, size_t>>>& grids,
    const std::vector<bool>& counts,
    const std::vector<bool>& good) {
  double sum = 0;
  size_t num_cells = 0;
  for (const auto& grid : grids) {
    for (size_t begin = 0; begin < grid.size();) {
      size_t num_counted = 0;
      size_t num_good = 0;
      size_t end = begin;
      for (; end < grid.size() && grid[end].first == grid[begin].first; ++end) {
        const size_t i = grid[end].second;
        num_counted += counts[i];
        num_good += counts[i] && good[i];
      }
      if (num_counted > 0) {
        sum += static_cast<double>(num_good) / static_cast<double>(num_counted);
        ++num_cells;
      }
      begin = end;
    }
  }
  return num_cells > 0 ? sum / static_cast<double>(num_cells) : 0;
}

std::vector<std::vector<std::pair<CellKey, size_t>>> GridsOf(
    const Points& points) {
  std::vector<std::vector<std::pair<CellKey, size_t>>> grids(2);
  for (size_t grid = 0; grid < grids.size(); ++grid) {
    const Eigen::Vector3d shift =
        Eigen::Vector3d::Constant(0.5 * static_cast<double>(grid));
    for (size_t i = 0; i < points.size(); ++i) {
      grids[grid].emplace_back(CellOf(points[i], kCellSize, shift), i);
    }
    std::sort(grids[grid].begin(), grids[grid].end());
  }
  return grids;
}

// The accuracy at each tolerance.
std::vector<double> MeasureAccuracy(const Points& points,
                                    const std::vector<LaserScan>& scans,
                                    const std::vector<double>& tolerances,
                                    const Context& context) {
  std::vector<PointClass> classes(points.size(), {tolerances.size(), false});
  Phase phase(context, "accuracy (ETH3D)", scans.size() * points.size());
  for (const LaserScan& scan : scans) {
    const ScanRays rays(scan);
    ParallelFor(
        context, points.size(), kCellGrain, [&](size_t begin, size_t end) {
          for (size_t i = begin; i < end; ++i) {
            rays.Classify(points[i], tolerances, &classes[i]);
          }
          phase.Advance(end - begin);
        });
  }
  const auto grids = GridsOf(points);
  std::vector<double> accuracy;
  for (size_t t = 0; t < tolerances.size(); ++t) {
    std::vector<bool> accurate(points.size());
    std::vector<bool> counts(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
      accurate[i] = classes[i].first_accurate <= t;
      counts[i] = accurate[i] || classes[i].inaccurate;
    }
    accuracy.push_back(MeanOverCells(grids, counts, accurate));
  }
  return accuracy;
}

}  // namespace

Points MergeScans(const std::vector<LaserScan>& scans) {
  Points merged;
  for (const LaserScan& scan : scans) {
    for (const Eigen::Vector3d& point : scan.points) {
      merged.push_back(scan.world_from_scan * point);
    }
  }
  return merged;
}

ProtocolResult MeasureEth3d(const IndexedMesh& mesh,
                            const std::vector<LaserScan>& scans,
                            std::vector<double> tolerances,
                            const Context& context) {
  std::sort(tolerances.begin(), tolerances.end());
  const Points points =
      PointsOfSurface(mesh,
                      std::min(kCellSize, tolerances.front()) / 2,
                      context.Seed(),
                      context);
  const std::vector<double> accuracy =
      MeasureAccuracy(points, scans, tolerances, context);
  const Points truth = MergeScans(scans);
  const std::vector<double> distances =
      ClosestDistances(truth, PointTree(points), context);
  const auto grids = GridsOf(truth);
  const std::vector<bool> all(truth.size(), true);
  ProtocolResult result;
  for (size_t t = 0; t < tolerances.size(); ++t) {
    std::vector<bool> complete(truth.size());
    for (size_t i = 0; i < truth.size(); ++i) {
      complete[i] = distances[i] <= tolerances[t];
    }
    result.scores.push_back(MakeScore(
        tolerances[t], accuracy[t], MeanOverCells(grids, all, complete)));
  }
  result.figures = {
      {"points", static_cast<double>(points.size()), FigureKind::kCount},
      {"scan points", static_cast<double>(truth.size()), FigureKind::kCount}};
  return result;
}

}  // namespace octacut
