#include "core/benchmark/compare/align_step.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kPairGrain = 512;
// Eigenvalues of the normal equations below this part of the largest belong
// to motions that the shape does not determine.
constexpr double kSmallestEigenvalue = 1e-6;
// Linearisation holds for small turns; radians and relative scale per step.
constexpr double kLargestTurn = 0.2;

using Matrix7d = Eigen::Matrix<double, 7, 7>;
using Vector7d = Eigen::Matrix<double, 7, 1>;

// Unknowns: turn, shift (in units of the size) and relative scale.
struct NormalEquations {
  Matrix7d matrix = Matrix7d::Zero();
  Vector7d right = Vector7d::Zero();
};

NormalEquations Accumulate(const std::vector<AlignPair>& pairs,
                           const Eigen::Vector3d& center,
                           double size,
                           bool estimate_scale,
                           const Context& context) {
  std::vector<NormalEquations> chunks(NumChunks(pairs.size(), kPairGrain));
  ParallelChunks(context,
                 pairs.size(),
                 kPairGrain,
                 [&](size_t chunk, size_t begin, size_t end) {
                   for (size_t i = begin; i < end; ++i) {
                     const AlignPair& pair = pairs[i];
                     if (!(pair.weight > 0)) {
                       continue;
                     }
                     const Eigen::Vector3d arm = (pair.moved - center) / size;
                     Vector7d row;
                     row << arm.cross(pair.normal), pair.normal,
                         estimate_scale ? arm.dot(pair.normal) : 0.0;
                     const double residual =
                         pair.normal.dot(pair.target - pair.moved) / size;
                     chunks[chunk].matrix +=
                         pair.weight * row * row.transpose();
                     chunks[chunk].right += pair.weight * residual * row;
                   }
                 });
  NormalEquations sum;
  for (const NormalEquations& chunk : chunks) {
    sum.matrix += chunk.matrix;
    sum.right += chunk.right;
  }
  return sum;
}

// The least squares solution of the smallest norm.
Vector7d Solve(const NormalEquations& equations) {
  // A compiler takes five seconds for Eigen's decomposition of this size.
  cv::Mat_<double> matrix(7, 7);
  for (int i = 0; i < 49; ++i) {
    matrix(i / 7, i % 7) = equations.matrix(i / 7, i % 7);
  }
  cv::Mat_<double> values;   // from the largest on
  cv::Mat_<double> vectors;  // one per row
  cv::eigen(matrix, values, vectors);
  Vector7d solution = Vector7d::Zero();
  for (int i = 0; i < 7; ++i) {
    if (values(i) > kSmallestEigenvalue * values(0)) {
      const Eigen::Map<const Vector7d> direction(vectors[i]);
      solution += direction * (direction.dot(equations.right) / values(i));
    }
  }
  return solution;
}

}  // namespace

AlignStep SolveAlignStep(const std::vector<AlignPair>& pairs,
                         const Eigen::Vector3d& center,
                         double size,
                         bool estimate_scale,
                         const Context& context) {
  Vector7d solution =
      Solve(Accumulate(pairs, center, size, estimate_scale, context));
  const double turn =
      std::max(solution.head<3>().norm(), std::abs(solution[6]));
  if (turn > kLargestTurn) {
    solution *= kLargestTurn / turn;
  }
  const Eigen::Vector3d axis = solution.head<3>();
  AlignStep step;
  step.largest_motion =
      axis.norm() + solution.segment<3>(3).norm() + std::abs(solution[6]);
  Similarity3d& motion = step.better_from_moved;
  motion.scale = 1 + solution[6];
  motion.rotation = Eigen::AngleAxisd(axis.norm(), axis.stableNormalized())
                        .toRotationMatrix();
  motion.translation = center + size * solution.segment<3>(3) -
                       motion.scale * (motion.rotation * center);
  return step;
}

}  // namespace octacut
