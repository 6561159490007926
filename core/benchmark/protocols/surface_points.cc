#include "core/benchmark/protocols/surface_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numeric>
#include <utility>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/benchmark/protocols/point_tree.h"
#include "core/mesh/surface_samples.h"
#include "core/mesh/triangle_normal.h"

namespace octacut {
namespace {

double AreaOf(const IndexedMesh& mesh) {
  double area = 0;
  for (const auto& triangle : mesh.triangles) {
    area += TriangleArea(mesh, triangle);
  }
  return area;
}

}  // namespace

std::vector<Eigen::Vector3d> UsedPoints(const IndexedMesh& mesh) {
  if (mesh.triangles.empty()) {
    return mesh.positions;
  }
  std::vector<bool> used(mesh.positions.size(), false);
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t vertex : triangle) {
      used[vertex] = true;
    }
  }
  std::vector<Eigen::Vector3d> points;
  for (size_t i = 0; i < used.size(); ++i) {
    if (used[i]) {
      points.push_back(mesh.positions[i]);
    }
  }
  return points;
}

std::vector<Eigen::Vector3d> PointsOfSurface(const IndexedMesh& mesh,
                                             double spacing,
                                             uint64_t seed,
                                             const Context& context) {
  std::vector<Eigen::Vector3d> points = UsedPoints(mesh);
  if (mesh.triangles.empty()) {
    return points;
  }
  const double count = std::ceil(AreaOf(mesh) / (spacing * spacing));
  if (!(count <= kMaxSurfacePoints)) {
    throw InputError(
        fmt::format("comparison: {:.3g} points at a spacing of {:g} would be "
                    "needed on the mesh; is it in the reference's units?",
                    count,
                    spacing));
  }
  const std::vector<SurfaceSample> samples =
      SampleSurface(mesh, static_cast<size_t>(count), seed, context);
  points.reserve(points.size() + samples.size());
  for (const SurfaceSample& sample : samples) {
    points.push_back(sample.point);
  }
  return points;
}

std::vector<Eigen::Vector3d> ThinPoints(std::vector<Eigen::Vector3d> points,
                                        double distance,
                                        uint64_t seed,
                                        const Context& context) {
  std::vector<std::pair<uint64_t, size_t>> order(points.size());
  for (size_t i = 0; i < order.size(); ++i) {
    order[i] = {HashBits(seed, i), i};
  }
  std::sort(order.begin(), order.end());
  const PointTree tree(std::move(points));
  std::vector<bool> kept(order.size(), true);
  // In portions, so that progress is shown and the run can be interrupted.
  constexpr size_t kPortion = 4096;
  Phase phase(context, "thinning of the points", order.size());
  for (size_t begin = 0; begin < order.size(); begin += kPortion) {
    const size_t end = std::min(begin + kPortion, order.size());
    for (size_t i = begin; i < end; ++i) {
      const size_t point = order[i].second;
      if (kept[point]) {
        for (const size_t other :
             tree.FindWithin(tree.Points()[point], distance)) {
          kept[other] = other == point;
        }
      }
    }
    phase.Advance(end - begin);
  }
  std::vector<Eigen::Vector3d> thinned;
  for (size_t i = 0; i < kept.size(); ++i) {
    if (kept[i]) {
      thinned.push_back(tree.Points()[i]);
    }
  }
  return thinned;
}

CellKey CellOf(const Eigen::Vector3d& point,
               double cell_size,
               const Eigen::Vector3d& shift) {
  CellKey key;
  for (int axis = 0; axis < 3; ++axis) {
    key[static_cast<size_t>(axis)] =
        static_cast<int64_t>(std::floor(point[axis] / cell_size + shift[axis]));
  }
  return key;
}

std::vector<Eigen::Vector3d> AverageInCells(
    const std::vector<Eigen::Vector3d>& points, double cell_size) {
  if (points.empty()) {
    return {};
  }
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) {
    box.extend(point);
  }
  std::vector<std::pair<CellKey, size_t>> cells(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    cells[i] = {
        CellOf(
            points[i] - box.min(), cell_size, Eigen::Vector3d::Constant(0.5)),
        i};
  }
  std::sort(cells.begin(), cells.end());
  std::vector<Eigen::Vector3d> means;
  for (size_t begin = 0; begin < cells.size();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    size_t end = begin;
    for (; end < cells.size() && cells[end].first == cells[begin].first;
         ++end) {
      sum += points[cells[end].second];
    }
    means.push_back(sum / static_cast<double>(end - begin));
    begin = end;
  }
  return means;
}

}  // namespace octacut
