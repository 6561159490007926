// How many of a set of distances lie within each of many thresholds.
#pragma once

#include <vector>

namespace octacut {

// Thresholds on a logarithmic scale, as fractions of the reference's diagonal:
// from a millionth, finer than any voxel, to the diagonal, 40 to a decade (6 %
// from one to the next).
inline constexpr int kCurveStepsPerDecade = 40;
inline constexpr int kCurveDecades = 6;
inline constexpr int kCurveSize = kCurveDecades * kCurveStepsPerDecade + 1;

// The i-th threshold, 0 <= i < kCurveSize.
double CurveThreshold(int i);

// The fractions of `sorted` distances, at least one, within each threshold
// times `diagonal`.
std::vector<double> DistanceCurve(const std::vector<double>& sorted,
                                  double diagonal);

}  // namespace octacut
