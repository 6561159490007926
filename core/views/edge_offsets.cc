#include "core/views/edge_offsets.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>

#include "core/views/border_lines.h"

namespace octacut {
namespace {

// Lines of a view are enough that its blur is known.
constexpr size_t kMaxBlurLines = 500;

// Of the variance, what a blur leaves in the better half of the lines; summed.
double ResidualShare(const OutlineFit& fit,
                     const std::vector<BorderLine>& lines) {
  const size_t stride = lines.size() / kMaxBlurLines + 1;
  std::vector<float> shares;
  for (size_t i = 0; i < lines.size(); i += stride) {
    if (lines[i].strongest) {
      const auto fitted = fit.Find(lines[i].light, lines[i].strongest->sample);
      shares.push_back(fitted ? fitted->residual_share : 1);
    }
  }
  std::sort(shares.begin(), shares.end());
  return std::accumulate(
      shares.begin(), shares.begin() + std::ptrdiff_t(shares.size() / 2), 0.0);
}

// That of the blur with which outlines fit best. On many lines something else
// is near, so the better half of them decides.
const OutlineFit& FitOfBlur(const std::vector<BorderLine>& lines,
                            std::span<const OutlineFit> fits) {
  std::vector<double> left;
  for (const OutlineFit& fit : fits) {
    left.push_back(ResidualShare(fit, lines));
  }
  return fits[size_t(std::min_element(left.begin(), left.end()) -
                     left.begin())];
}

// Pixels from the middle; none if the line has no outline at the edge. Beside
// another edge, where a surface does not just turn away, the outline is taken
// to be where the edge is steepest.
std::optional<float> OutlineAt(const BorderEdge& edge,
                               const BorderLine& line,
                               const OutlineFit& fit) {
  if (!edge.stands_alone) {
    return edge.steepest;
  }
  const auto fitted = fit.Find(line.light, edge.sample);
  if (!fitted || !fitted->position) {
    return std::nullopt;
  }
  return PixelsFromMiddle(*fitted->position);
}

}  // namespace

EdgeOffsets FindEdgeOffsets(const PreparedView& view,
                            std::span<const OutlineFit> fits) {
  const std::vector<BorderLine> lines = FindBorderLines(view);
  const OutlineFit& fit = FitOfBlur(lines, fits);
  EdgeOffsets offsets;
  for (const BorderLine& line : lines) {
    if (line.strongest) {
      // Lines without an outline count, too: it is a share of all lines that
      // has to agree.
      offsets.strongest.push_back(OutlineAt(*line.strongest, line, fit)
                                      .value_or(line.strongest->steepest) -
                                  line.border);
    }
    if (line.nearest) {
      if (const auto outline = OutlineAt(*line.nearest, line, fit)) {
        offsets.nearest.push_back(*outline - line.border);
      }
    }
  }
  return offsets;
}

}  // namespace octacut
