// Edges of a photograph on lines across the border of its mask.
#pragma once

#include <array>
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/views/outline_fit.h"
#include "core/views/view_set.h"

namespace octacut {

// Pixels from the border within which edges are looked for: masks that are
// farther off are wrong, not shifted.
inline constexpr float kEdgeRange = 6;
// Samples of a line before and behind that range, for the fit of outlines.
inline constexpr int kLineMargin = kOutlineSearch + kOutlineWindow;
inline constexpr int kLineSamples =
    int(2 * kEdgeRange / kEdgeStep) + 1 + 2 * kLineMargin;

struct BorderEdge {
  int sample;
  float steepest;     // pixels from the middle, positive inside
  bool stands_alone;  // no comparable edge is within the window of an outline
};

// From outside to inside.
struct BorderLine {
  std::array<Eigen::Vector3f, kLineSamples> light;  // linear
  float border;  // of the mask, pixels from the middle
  // None where it is at an end, too faint, or beside clipped pixels.
  std::optional<BorderEdge> strongest;
  // The nearest one to the middle that is comparable to the strongest.
  std::optional<BorderEdge> nearest;
};

// Pixels from the middle of a sample, which need not be a whole number.
inline float PixelsFromMiddle(float sample) {
  return (sample - float(kLineMargin)) * kEdgeStep - kEdgeRange;
}

// At the points of the mask's border that are clear of the frame, as far as
// there are edges. `view` has an image.
std::vector<BorderLine> FindBorderLines(const PreparedView& view);

}  // namespace octacut
