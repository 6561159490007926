// Edges of a photograph on lines across the border of its mask.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/views/outline_fit.h"
#include "core/views/view_set.h"

namespace octacut {

// Pixels from the middle of a line within which its edges are looked for.
inline constexpr float kEdgeRange = 6;
// The same where it is not known yet where most edges are: masks that are
// farther off are wrong, not shifted.
inline constexpr float kWideEdgeRange = 16;
// Samples of a line before and behind that range, for the fit of outlines.
inline constexpr int kLineMargin = kOutlineSearch + kOutlineWindow;

struct BorderEdge {
  int sample;
  float steepest;     // pixels from the middle, positive inside
  bool stands_alone;  // no comparable edge is within the window of an outline
};

// From outside to inside.
struct BorderLine {
  std::vector<Eigen::Vector3f> light;  // linear
  float border;                        // of the mask, pixels from the middle
  // None where it is at an end, too faint, or beside clipped pixels.
  std::optional<BorderEdge> strongest;
  // The nearest one to the middle that is comparable to the strongest.
  std::optional<BorderEdge> nearest;
};

// Pixels from the middle of a line of that range to a sample, which need not be
// a whole number.
inline float PixelsFromMiddle(float sample, float range = kEdgeRange) {
  return (sample - float(kLineMargin)) * kEdgeStep - range;
}

// Lines of kEdgeRange at the points of the mask's border that are clear of the
// frame, as far as there are edges. `view` has an image.
std::vector<BorderLine> FindBorderLines(const PreparedView& view);

// Pixels of edges from the mask's border, positive inside.
struct EdgePositions {
  std::vector<float> all;
  std::vector<float> comparable;  // to the strongest edge of their line
  size_t num_lines = 0;           // with and without edges
};

// On lines of kWideEdgeRange. `view` has an image.
EdgePositions FindAllEdges(const PreparedView& view);

}  // namespace octacut
