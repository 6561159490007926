// A tree of boxes over triangles, packed into arrays: the triangles in Morton
// order of their centres, each level groups eight neighbours of the one below
// (Kamel & Faloutsos 1993, with Morton's curve).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

class BoxTree {
 public:
  // Only of the triangles with `used` != 0, whose coordinates are finite.
  BoxTree(const IndexedMesh& mesh,
          const std::vector<uint8_t>& used,
          const Context& context);

  // Number of triangles in the tree; a leaf is a position in their order.
  size_t NumLeaves() const { return order_.size(); }
  uint32_t Triangle(size_t leaf) const { return order_[leaf]; }

  // Calls visit(leaf, other) for each of the leaves from `begin` to `end` and
  // the leaves after it whose boxes touch its own.
  template <typename Visit>
  void ForPairs(size_t begin, size_t end, const Visit& visit) const {
    const std::vector<Box>& leaves = levels_[0];
    std::vector<size_t> others;
    while (begin < end) {
      // Neighbors in the order are neighbors in space, so a group shares a
      // descent.
      const size_t group_end = std::min(begin + kFanOut, end);
      Box group = leaves[begin];
      for (size_t leaf = begin + 1; leaf < group_end; ++leaf) {
        Extend(leaves[leaf], &group);
      }
      others.clear();
      VisitFrom(
          begin + 1, group, [&](size_t other) { others.push_back(other); });
      for (; begin < group_end; ++begin) {
        for (const size_t other : others) {
          if (other > begin && Touch(leaves[begin], leaves[other])) {
            visit(begin, other);
          }
        }
      }
    }
  }

  // Calls visit(leaf) for the leaves whose boxes touch that of a triangle that
  // need not be in the tree and has finite coordinates.
  template <typename Visit>
  void ForTouching(const IndexedMesh& mesh,
                   uint32_t triangle,
                   const Visit& visit) const {
    if (!levels_.empty()) {
      VisitFrom(0, RoundedBox(mesh, triangle), visit);
    }
  }

 private:
  static constexpr size_t kFanOut = 8;
  static constexpr int kLogFanOut = 3;

  // Rounded outward, relative to the centre of the mesh.
  struct Box {
    float min[3];
    float max[3];
  };

  static bool Touch(const Box& a, const Box& b) {
    return a.min[0] <= b.max[0] && b.min[0] <= a.max[0] &&
           a.min[1] <= b.max[1] && b.min[1] <= a.max[1] &&
           a.min[2] <= b.max[2] && b.min[2] <= a.max[2];
  }

  static void Extend(const Box& by, Box* box) {
    for (int axis = 0; axis < 3; ++axis) {
      box->min[axis] = std::min(box->min[axis], by.min[axis]);
      box->max[axis] = std::max(box->max[axis], by.max[axis]);
    }
  }

  // Leaves from `first` on whose boxes touch `box`.
  template <typename Visit>
  void VisitFrom(size_t first, const Box& box, const Visit& visit) const {
    const size_t top = levels_.size() - 1;
    for (size_t node = 0; node < levels_[top].size(); ++node) {
      Descend(box, first, top, node, visit);
    }
  }

  template <typename Visit>
  void Descend(const Box& box,
               size_t first,
               size_t level,
               size_t node,
               const Visit& visit) const {
    const size_t leaves_end = (node + 1) << (kLogFanOut * level);
    if (leaves_end <= first || !Touch(box, levels_[level][node])) {
      return;
    }
    if (level == 0) {
      visit(node);
      return;
    }
    const size_t end =
        std::min(levels_[level - 1].size(), (node + 1) * kFanOut);
    for (size_t child = node * kFanOut; child < end; ++child) {
      Descend(box, first, level - 1, child, visit);
    }
  }

  Box RoundedBox(const IndexedMesh& mesh, uint32_t triangle) const;
  void BuildLevels(const Context& context);

  Eigen::Vector3d center_ = Eigen::Vector3d::Zero();
  std::vector<uint32_t> order_;
  std::vector<std::vector<Box>> levels_;  // leaves first
};

}  // namespace octacut
