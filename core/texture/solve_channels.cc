#include "core/texture/solve_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <Eigen/IterativeLinearSolvers>

#include "core/base/parallel.h"

namespace octacut {
namespace {

// Of the right side, whose values are up to 255 grey levels: about a hundredth
// of a level, which changes no byte.
constexpr double kTolerance = 1e-5;
constexpr int kMaxIterations = 2000;

}  // namespace

void SolveChannels(const SymmetricMatrix& matrix,
                   const Eigen::MatrixX3d& right,
                   std::string_view what,
                   const Context& context,
                   Eigen::MatrixX3d* x) {
  std::array<double, 3> errors{};
  ParallelEach(context, 3, 1, [&](size_t c) {
    Eigen::ConjugateGradient<SymmetricMatrix, Eigen::Lower | Eigen::Upper>
        solver;
    solver.setTolerance(kTolerance);
    solver.setMaxIterations(kMaxIterations);
    solver.compute(matrix);
    x->col(Eigen::Index(c)) = solver.solveWithGuess(right.col(Eigen::Index(c)),
                                                    x->col(Eigen::Index(c)));
    errors[c] = solver.error();
  });
  const double error = *std::max_element(errors.begin(), errors.end());
  if (!(error <= kTolerance)) {
    context.Warn(fmt::format(
        "the colours of the texture are not solved for exactly: after {} steps "
        "a part of {:.2g} is left, and {} may be visible",
        kMaxIterations,
        error,
        what));
  }
}

}  // namespace octacut
