#include "core/extract/triangulate_loop.h"

#include <Eigen/Geometry>
#include <limits>

namespace octacut {
namespace {

using Triangulation = std::vector<LoopTriangle>;

// All triangulations of the corners first .. last, whose chord first - last
// is given.
std::vector<Triangulation> Enumerate(int first, int last) {
  if (last - first < 2) {
    return {Triangulation{}};
  }
  std::vector<Triangulation> all;
  for (int apex = first + 1; apex < last; ++apex) {
    for (const Triangulation& left : Enumerate(first, apex)) {
      for (const Triangulation& right : Enumerate(apex, last)) {
        Triangulation triangles{{uint8_t(first), uint8_t(apex), uint8_t(last)}};
        triangles.insert(triangles.end(), left.begin(), left.end());
        triangles.insert(triangles.end(), right.begin(), right.end());
        all.push_back(std::move(triangles));
      }
    }
  }
  return all;
}

std::vector<LoopTriangle> Flatten(int size) {
  std::vector<LoopTriangle> flat;
  for (const Triangulation& triangles : Enumerate(0, size - 1)) {
    flat.insert(flat.end(), triangles.begin(), triangles.end());
  }
  return flat;
}

float ShapeCost(const Eigen::Vector3f& a,
                const Eigen::Vector3f& b,
                const Eigen::Vector3f& c) {
  // A degenerate triangle costs much, but finitely: the fewest win.
  constexpr float kTinyArea = 1e-4f;
  const float edges =
      (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  const float area = (b - a).cross(c - a).norm();
  return (edges + kTinyArea) / (area + kTinyArea);
}

}  // namespace

const std::vector<LoopTriangle>& LoopTriangulations(int size) {
  static const std::array<std::vector<LoopTriangle>, 3> tables = {
      Flatten(4), Flatten(6), Flatten(8)};
  return tables[(size - 4) / 2];
}

int ChooseTriangulation(std::span<const Eigen::Vector3f> corners) {
  const int size = int(corners.size());
  float cost_of[8][8][8];
  for (int i = 0; i < size; ++i) {
    for (int j = i + 1; j < size; ++j) {
      for (int k = j + 1; k < size; ++k) {
        cost_of[i][j][k] = ShapeCost(corners[i], corners[j], corners[k]);
      }
    }
  }
  const std::vector<LoopTriangle>& all = LoopTriangulations(size);
  const int num_choices = int(all.size()) / (size - 2);
  int best = 0;
  float best_cost = std::numeric_limits<float>::infinity();
  const LoopTriangle* triangle = all.data();
  for (int choice = 0; choice < num_choices; ++choice) {
    float cost = 0;
    for (int t = 0; t < size - 2; ++t, ++triangle) {
      cost += cost_of[(*triangle)[0]][(*triangle)[1]][(*triangle)[2]];
    }
    if (cost < best_cost) {
      best_cost = cost;
      best = choice;
    }
  }
  return best;
}

}  // namespace octacut
