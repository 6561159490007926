#include "core/mesh/box_tree.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <utility>

#include "core/base/morton.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kNodeGrain = 8192;

uint32_t ToCell(double position) {
  // Coordinates near the end of doubles may have overflown.
  return position >= 0 && position < 1 << 21 ? static_cast<uint32_t>(position)
                                             : 0;
}

Eigen::AlignedBox3d BoxOf(const IndexedMesh& mesh, uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  Eigen::AlignedBox3d box(mesh.positions[a]);
  box.extend(mesh.positions[b]);
  box.extend(mesh.positions[c]);
  return box;
}

// More than half of the last bit, also of what is nearly 0.
float RoundingOf(float value) {
  return std::numeric_limits<float>::epsilon() * std::abs(value) +
         std::numeric_limits<float>::min();
}

float RoundDown(double value) {
  const float rounded = static_cast<float>(value);
  return rounded - RoundingOf(rounded);
}

float RoundUp(double value) {
  const float rounded = static_cast<float>(value);
  return rounded + RoundingOf(rounded);
}

}  // namespace

BoxTree::BoxTree(const IndexedMesh& mesh,
                 const std::vector<uint8_t>& used,
                 const Context& context) {
  Eigen::AlignedBox3d bounds;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (used[i] != 0) {
      order_.push_back(static_cast<uint32_t>(i));
      bounds.extend(BoxOf(mesh, order_.back()));
    }
  }
  if (order_.empty()) {
    return;
  }
  center_ = bounds.center();
  const double size = bounds.sizes().maxCoeff();
  const double cells = size > 0 ? ((1 << 21) - 1) / size : 0.0;
  std::vector<std::pair<uint64_t, uint32_t>> keys(order_.size());
  ParallelEach(context, keys.size(), kNodeGrain, [&](size_t i) {
    const Eigen::Vector3d cell =
        (BoxOf(mesh, order_[i]).center() - bounds.min()) * cells;
    keys[i] = {
        EncodeMorton(ToCell(cell.x()), ToCell(cell.y()), ToCell(cell.z())),
        order_[i]};
  });
  std::sort(keys.begin(), keys.end());
  levels_.emplace_back(keys.size());
  ParallelEach(context, keys.size(), kNodeGrain, [&](size_t i) {
    order_[i] = keys[i].second;
    levels_[0][i] = RoundedBox(mesh, order_[i]);
  });
  BuildLevels(context);
}

BoxTree::Box BoxTree::RoundedBox(const IndexedMesh& mesh,
                                 uint32_t triangle) const {
  const Eigen::AlignedBox3d box = BoxOf(mesh, triangle);
  Box rounded;
  for (int axis = 0; axis < 3; ++axis) {
    rounded.min[axis] = RoundDown(box.min()[axis] - center_[axis]);
    rounded.max[axis] = RoundUp(box.max()[axis] - center_[axis]);
  }
  return rounded;
}

void BoxTree::BuildLevels(const Context& context) {
  while (levels_.back().size() > kFanOut) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> level(NumChunks(below.size(), kFanOut));
    ParallelEach(context, level.size(), kNodeGrain, [&](size_t i) {
      Box box = below[i * kFanOut];
      const size_t last = std::min(below.size(), (i + 1) * kFanOut);
      for (size_t child = i * kFanOut + 1; child < last; ++child) {
        Extend(below[child], &box);
      }
      level[i] = box;
    });
    levels_.push_back(std::move(level));
  }
}

}  // namespace octacut
