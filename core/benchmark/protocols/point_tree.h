// Closest points and neighbourhoods in a cloud of points (nanoflann behind it).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "core/base/context.h"

namespace octacut {

class PointTree {
 public:
  struct Closest {
    size_t index;
    double distance;
  };

  // Copies the points, of which there is at least one; their coordinates are
  // finite.
  explicit PointTree(std::vector<Eigen::Vector3d> points);
  ~PointTree();
  PointTree(const PointTree&) = delete;
  PointTree& operator=(const PointTree&) = delete;

  const std::vector<Eigen::Vector3d>& Points() const;

  // Both may be called from any thread.
  Closest FindClosest(const Eigen::Vector3d& query) const;
  // Indices of the points at `radius` or less, in ascending order.
  std::vector<size_t> FindWithin(const Eigen::Vector3d& query,
                                 double radius) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The distance of each query to the closest point.
std::vector<double> ClosestDistances(
    const std::vector<Eigen::Vector3d>& queries,
    const PointTree& tree,
    const Context& context);

}  // namespace octacut
