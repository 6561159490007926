#include "core/benchmark/protocols/point_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kQueryGrain = 2048;
// Points of a leaf; nanoflann's documentation recommends 10 to 50.
constexpr size_t kLeafSize = 16;

// What nanoflann asks of a cloud; the names are its own.
struct TreePoints {
  std::vector<Eigen::Vector3d> points;

  size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(size_t index, size_t axis) const {
    return points[index][static_cast<Eigen::Index>(axis)];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<
    nanoflann::L2_Simple_Adaptor<double, TreePoints>,
    TreePoints,
    3,
    size_t>;

}  // namespace

struct PointTree::Impl {
  explicit Impl(std::vector<Eigen::Vector3d> points)
      : cloud{std::move(points)},
        tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize)) {
    tree.buildIndex();
  }
  TreePoints cloud;
  Tree tree;
};

PointTree::PointTree(std::vector<Eigen::Vector3d> points) {
  if (points.empty()) {
    throw InputError("comparison: there are no points to measure distances to");
  }
  impl_ = std::make_unique<Impl>(std::move(points));
}

PointTree::~PointTree() = default;

const std::vector<Eigen::Vector3d>& PointTree::Points() const {
  return impl_->cloud.points;
}

PointTree::Closest PointTree::FindClosest(const Eigen::Vector3d& query) const {
  size_t index = 0;
  double squared = 0;
  impl_->tree.knnSearch(query.data(), 1, &index, &squared);
  return {index, std::sqrt(squared)};
}

std::vector<size_t> PointTree::FindWithin(const Eigen::Vector3d& query,
                                          double radius) const {
  // nanoflann leaves out points at exactly the radius.
  const double squared =
      std::nextafter(radius * radius, std::numeric_limits<double>::infinity());
  std::vector<std::pair<size_t, double>> found;
  impl_->tree.radiusSearch(
      query.data(), squared, found, nanoflann::SearchParams(32, 0, false));
  std::vector<size_t> indices;
  indices.reserve(found.size());
  for (const auto& [index, distance] : found) {
    indices.push_back(index);
  }
  std::sort(indices.begin(), indices.end());
  return indices;
}

std::vector<double> ClosestDistances(
    const std::vector<Eigen::Vector3d>& queries,
    const PointTree& tree,
    const Context& context) {
  std::vector<double> distances(queries.size());
  Phase phase(context, "distances between points", queries.size());
  ParallelFor(
      context, queries.size(), kQueryGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          distances[i] = tree.FindClosest(queries[i]).distance;
        }
        phase.Advance(end - begin);
      });
  return distances;
}

}  // namespace octacut
