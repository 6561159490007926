#include "core/views/outline_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/parabola.h"

namespace octacut {
namespace {

// The mean of `function` around t, weighted by a Gaussian.
template <typename Function>
double Blurred(const Function& function, double t, double deviation) {
  constexpr int kSteps = 200;  // on each side
  constexpr double kDeviations = 4;
  double sum = 0;
  double weights = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double x = kDeviations * i / kSteps;
    const double weight = std::exp(-0.5 * x * x);
    sum += weight * function(t + x * deviation);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

OutlineFit::OutlineFit(double blur) : blur_(blur) {
  using Columns = Eigen::Matrix<double, kSamples, 3>;
  Columns columns;
  for (int i = 0; i < kSamples; ++i) {
    const double t = kEdgeStep * (i - kOutlineWindow);
    columns.row(i) << 1,
        Blurred([](double s) { return s > 0 ? 1.0 : 0.0; }, t, blur),
        Blurred([](double s) { return std::sqrt(std::max(s, 0.0)); }, t, blur);
  }
  // Gram and Schmidt.
  for (int k = 0; k < 3; ++k) {
    for (int before = 0; before < k; ++before) {
      columns.col(k) -=
          columns.col(before).dot(columns.col(k)) * columns.col(before);
    }
    columns.col(k).normalize();
  }
  basis_ = columns.cast<float>();
}

std::optional<FittedOutline> OutlineFit::Find(
    std::span<const Eigen::Vector3f> samples, int near, bool is_wide) const {
  const int begin = near - kOutlineSearch - kOutlineWindow;
  if (begin < 0 ||
      near + kOutlineSearch + kOutlineWindow >= int(samples.size())) {
    return std::nullopt;
  }
  const auto window = [&](Eigen::Index i) {
    return Eigen::Map<const Eigen::Matrix<float, 3, kSamples>>(
        samples.front().data() + 3 * (begin + i));
  };
  // Sums of squared residuals, by position.
  Eigen::Array<float, 2 * kOutlineSearch + 1, 1> residuals;
  for (Eigen::Index i = 0; i < residuals.size(); ++i) {
    residuals[i] = window(i).squaredNorm() - (window(i) * basis_).squaredNorm();
  }
  Eigen::Index best = 0;
  residuals.minCoeff(&best);
  if (best == 0 && is_wide) {
    return Find(samples, near - kOutlineSearch, false);
  }
  FittedOutline fitted;
  const float variance =
      (window(best).colwise() - window(best).rowwise().mean()).squaredNorm();
  if (variance > 0) {
    fitted.residual_share = std::max(residuals[best], 0.0f) / variance;
  }
  if (best > 0 && best + 1 < residuals.size()) {
    fitted.position =
        float(near - kOutlineSearch + int(best)) +
        ParabolaExtremum(
            residuals[best - 1], residuals[best], residuals[best + 1]);
  }
  return fitted;
}

}  // namespace octacut
