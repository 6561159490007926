#include "core/mesh/thin_triangles.h"

#include <algorithm>
#include <Eigen/Geometry>
#include <unordered_map>

#include "core/base/parallel.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {
namespace {

constexpr size_t kTriangleGrain = 1 << 15;
// What is left of the way at each step.
constexpr std::array<double, 5> kFractions = {1, 0.5, 0.25, 0.125, 0};

using Triangles = std::vector<std::array<uint32_t, 3>>;
using Positions = std::vector<Eigen::Vector3d>;

std::vector<uint32_t> FindThin(const Triangles& triangles,
                               const Positions& positions,
                               double min_height,
                               const Context& context) {
  std::vector<std::vector<uint32_t>> chunks(
      NumChunks(triangles.size(), kTriangleGrain));
  ParallelChunks(context,
                 triangles.size(),
                 kTriangleGrain,
                 [&](size_t chunk, size_t begin, size_t end) {
                   for (size_t t = begin; t < end; ++t) {
                     if (IsThin(positions, triangles[t], min_height)) {
                       chunks[chunk].push_back(uint32_t(t));
                     }
                   }
                 });
  std::vector<uint32_t> thin;
  for (const std::vector<uint32_t>& chunk : chunks) {
    thin.insert(thin.end(), chunk.begin(), chunk.end());
  }
  return thin;
}

void SortUnique(std::vector<uint32_t>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

bool IsThin(const Positions& positions,
            const std::array<uint32_t, 3>& triangle,
            double min_height) {
  const Eigen::Vector3d ab = positions[triangle[1]] - positions[triangle[0]];
  const Eigen::Vector3d ac = positions[triangle[2]] - positions[triangle[0]];
  const double longest =
      std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
  // height = 2 area / longest edge
  return !(ab.cross(ac).squaredNorm() >= min_height * min_height * longest);
}

WithdrawSummary WithdrawFromThinTriangles(const Triangles& triangles,
                                          const Positions& start,
                                          double min_height,
                                          const Context& context,
                                          Positions& positions) {
  std::vector<uint32_t> thin =
      FindThin(triangles, positions, min_height, context);
  if (thin.empty()) {
    return {};
  }
  WithdrawSummary summary;
  const VertexCorners corners = FindVertexCorners(start.size(), triangles);
  struct Withdrawn {
    Eigen::Vector3d target;
    size_t step;
  };
  std::unordered_map<uint32_t, Withdrawn> withdrawn;
  while (!thin.empty()) {
    context.ThrowIfCancelled();
    std::vector<uint32_t> moved;
    for (const uint32_t t : thin) {
      moved.insert(moved.end(), triangles[t].begin(), triangles[t].end());
    }
    SortUnique(moved);
    std::erase_if(moved, [&](uint32_t vertex) {
      Withdrawn& state =
          withdrawn.try_emplace(vertex, Withdrawn{positions[vertex], 0})
              .first->second;
      if (state.step + 1 == kFractions.size()) {
        return true;
      }
      const double fraction = kFractions[++state.step];
      positions[vertex] =
          start[vertex] + fraction * (state.target - start[vertex]);
      return false;
    });
    // What became thin, or still is; a triangle none of whose vertices can
    // move is given up.
    std::vector<uint32_t> next;
    for (const uint32_t vertex : moved) {
      for (const uint32_t corner : corners.Of(vertex)) {
        next.push_back(corner / 3);
      }
    }
    SortUnique(next);
    std::erase_if(next, [&](uint32_t t) {
      return !IsThin(positions, triangles[t], min_height);
    });
    thin = std::move(next);
  }
  for (const auto& [vertex, state] : withdrawn) {
    summary.num_withdrawn += state.target != start[vertex] ? 1 : 0;
    for (const uint32_t corner : corners.Of(vertex)) {
      // Each once, at its first corner that was withdrawn.
      const auto& triangle = triangles[corner / 3];
      bool first = true;
      for (uint32_t i = 0; i < corner % 3; ++i) {
        first &= !withdrawn.contains(triangle[i]);
      }
      summary.num_thin += first && IsThin(positions, triangle, min_height);
    }
  }
  return summary;
}

}  // namespace octacut
