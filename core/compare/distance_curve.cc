#include "core/compare/distance_curve.h"

#include <algorithm>
#include <cmath>

namespace octacut {

double CurveThreshold(int i) {
  return std::pow(
      10.0, static_cast<double>(i) / kCurveStepsPerDecade - kCurveDecades);
}

std::vector<double> DistanceCurve(const std::vector<double>& sorted,
                                  double diagonal) {
  std::vector<double> fractions(kCurveSize);
  for (int i = 0; i < kCurveSize; ++i) {
    const auto end = std::upper_bound(
        sorted.begin(), sorted.end(), CurveThreshold(i) * diagonal);
    fractions[static_cast<size_t>(i)] =
        static_cast<double>(end - sorted.begin()) /
        static_cast<double>(sorted.size());
  }
  return fractions;
}

}  // namespace octacut
