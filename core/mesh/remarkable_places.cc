#include "core/mesh/remarkable_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace octacut {

std::vector<RemarkablePlace> FindRemarkablePlaces(
    const IndexedMesh& mesh,
    const std::vector<float>& values,
    const std::vector<Eigen::Vector3f>& normals,
    size_t count,
    double distance) {
  std::vector<uint32_t> order;
  for (uint32_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) {
      order.push_back(i);
    }
  }
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return values[a] != values[b] ? values[a] > values[b] : a < b;
  });
  std::vector<RemarkablePlace> places;
  for (const uint32_t vertex : order) {
    if (places.size() == count) {
      break;
    }
    const Eigen::Vector3d& position = mesh.positions[vertex];
    const bool is_near = std::any_of(
        places.begin(), places.end(), [&](const RemarkablePlace& place) {
          return (place.position - position).norm() < distance;
        });
    if (!is_near) {
      places.push_back(
          {vertex, values[vertex], position, normals[vertex].cast<double>()});
    }
  }
  return places;
}

std::vector<float> CellMeans(const IndexedMesh& mesh,
                             const std::vector<float>& values,
                             double cell_edge,
                             size_t least_count) {
  using Cell = std::array<int64_t, 3>;
  const auto cell_of = [&](size_t vertex) {
    const Eigen::Vector3d cell =
        (mesh.positions[vertex] / cell_edge).array().floor();
    return Cell{static_cast<int64_t>(cell.x()),
                static_cast<int64_t>(cell.y()),
                static_cast<int64_t>(cell.z())};
  };
  std::map<Cell, std::pair<double, size_t>> sums;
  for (size_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) {
      auto& [sum, count] = sums[cell_of(i)];
      sum += values[i];
      ++count;
    }
  }
  std::vector<float> means(values.size(),
                           std::numeric_limits<float>::quiet_NaN());
  for (size_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) {
      const auto& [sum, count] = sums.at(cell_of(i));
      if (count >= least_count) {
        means[i] = static_cast<float>(sum / static_cast<double>(count));
      }
    }
  }
  return means;
}

}  // namespace octacut
