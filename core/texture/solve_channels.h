// Sparse least squares for the three channels of colours.
#pragma once

#include <Eigen/SparseCore>
#include <string_view>

#include "core/base/context.h"

namespace octacut {

using SymmetricMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Solves `matrix` * x = `right` by conjugate gradients, one column per channel
// (grey levels), from `x` on, until the residual is 1e-5 of `right`. Warns that
// `what` may be seen where they do not converge.
void SolveChannels(const SymmetricMatrix& matrix,
                   const Eigen::MatrixX3d& right,
                   std::string_view what,
                   const Context& context,
                   Eigen::MatrixX3d* x);

}  // namespace octacut
