// The extremum of a parabola through three values.
#pragma once

namespace octacut {

// Where a parabola through three equidistant values has its extremum, in steps
// from the middle one, which is the largest or the least; 0 on a line.
inline float ParabolaExtremum(float before, float middle, float after) {
  const float curvature = before - 2 * middle + after;
  return curvature != 0 ? 0.5f * (before - after) / curvature : 0;
}

}  // namespace octacut
