#include "core/benchmark/protocols/dtu.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/benchmark/protocols/point_tree.h"
#include "core/benchmark/protocols/surface_points.h"

namespace octacut {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// Millimetres.
constexpr double kSpacing = 0.2;
constexpr double kBlock = 60;    // MaxDist of PointCompareMain.m
constexpr double kOutlier = 20;  // MaxDist of ComputeStat_web.m

// MaxDistCP.m walks over blocks of 60 mm that begin at the box's minimum and
// cover its maximum. Points in none of them get 60 mm, so they are outliers.
bool IsInBlocks(const Eigen::Vector3d& point, const ObservabilityMask& mask) {
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = mask.box_max[axis] - mask.box_min[axis];
    const double end =
        mask.box_min[axis] + kBlock * (std::floor(extent / kBlock) + 1);
    if (!(point[axis] >= mask.box_min[axis] && point[axis] < end)) {
      return false;
    }
  }
  return true;
}

// The distances of the points that count, sorted.
std::vector<double> JudgedDistances(Points points,
                                    const PointTree& tree,
                                    const ObservabilityMask& mask,
                                    const char* which,
                                    const Context& context) {
  std::erase_if(points, [&](const Eigen::Vector3d& point) {
    return !IsInBlocks(point, mask);
  });
  std::vector<double> distances = ClosestDistances(points, tree, context);
  std::erase_if(distances, [](double d) { return d >= kOutlier; });
  if (distances.empty()) {
    throw InputError(fmt::format(
        "dtu: no point of the {} counts: all are outside of the mask, below "
        "the plane, or {} mm or more away; DTU's unit is the millimetre",
        which,
        kOutlier));
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

double Mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(values.size());
}

double Median(const std::vector<double>& sorted) {
  const size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle]
                                : (sorted[middle - 1] + sorted[middle]) / 2;
}

}  // namespace

bool ObservabilityMask::Contains(const Eigen::Vector3d& point) const {
  size_t index = 0;
  size_t stride = 1;
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    // Rounded as in MATLAB, which counts cells from 1.
    const double cell = std::round((point[a] - box_min[a]) / cell_size + 1) - 1;
    if (!(cell >= 0 && cell < static_cast<double>(size[axis]))) {
      return false;
    }
    index += stride * static_cast<size_t>(cell);
    stride *= size[axis];
  }
  return cells[index] != 0;
}

ProtocolResult MeasureDtu(const IndexedMesh& mesh,
                          const IndexedMesh& reference,
                          const ObservabilityMask& mask,
                          const Eigen::Vector4d& plane,
                          const Context& context) {
  const PointTree data(
      ThinPoints(PointsOfSurface(mesh, kSpacing, context.Seed(), context),
                 kSpacing,
                 context.Seed(),
                 context));
  const PointTree truth(
      PointsOfSurface(reference, kSpacing, context.Seed() + 1, context));
  Points observed = data.Points();
  std::erase_if(observed, [&](const Eigen::Vector3d& point) {
    return !mask.Contains(point);
  });
  Points above = truth.Points();
  std::erase_if(above, [&](const Eigen::Vector3d& point) {
    return !(plane.head<3>().dot(point) + plane[3] > 0);
  });
  const std::vector<double> to =
      JudgedDistances(std::move(observed), truth, mask, "mesh", context);
  const std::vector<double> from =
      JudgedDistances(std::move(above), data, mask, "reference", context);
  ProtocolResult result;
  result.figures = {
      {"accuracy", Mean(to)},
      {"accuracy median", Median(to)},
      {"completeness", Mean(from)},
      {"completeness median", Median(from)},
      {"overall", (Mean(to) + Mean(from)) / 2},
      {"points", static_cast<double>(to.size()), FigureKind::kCount},
      {"reference points",
       static_cast<double>(from.size()),
       FigureKind::kCount}};
  return result;
}

}  // namespace octacut
