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
// With more blur, pixels, the window of a fit is too narrow to tell a step from
// a square root (docs/experiments/mask_borders.md).
constexpr double kLeastUnknownBlur = 1.2;

// The variance that a blur leaves in the better half of the lines, as a share.
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

// Pixels from the middle; none if the line has no outline at the edge.
std::optional<float> OutlineAt(const BorderEdge& edge,
                               const BorderLine& line,
                               const OutlineFit& fit) {
  const auto fitted = fit.Find(line.light, edge.sample);
  if (!fitted || !fitted->position) {
    return std::nullopt;
  }
  return PixelsFromMiddle(*fitted->position);
}

// Whether most edges that stand alone have an outline.
bool FitsMost(const OutlineFit& fit, const std::vector<BorderLine>& lines) {
  size_t count = 0;
  size_t num_found = 0;
  for (const BorderLine& line : lines) {
    if (line.strongest && line.strongest->stands_alone) {
      ++count;
      num_found += OutlineAt(*line.strongest, line, fit) ? 1 : 0;
    }
  }
  return 2 * num_found > count;
}

}  // namespace

EdgeOffsets FindEdgeOffsets(const PreparedView& view,
                            std::span<const OutlineFit> fits) {
  const std::vector<BorderLine> lines = FindBorderLines(view);
  const OutlineFit& fit = FitOfBlur(lines, fits);
  const bool is_blur_known =
      fit.Blur() < kLeastUnknownBlur && FitsMost(fit, lines);
  // Where it is not known, or where a surface has other edges beside its
  // outline and does not just turn away, the steepest point is taken.
  const auto outline = [&](const BorderEdge& edge, const BorderLine& line) {
    return is_blur_known && edge.stands_alone
               ? OutlineAt(edge, line, fit)
               : std::optional<float>(edge.steepest);
  };
  EdgeOffsets offsets;
  for (const BorderLine& line : lines) {
    std::optional<float> at_strongest;
    if (line.strongest) {
      at_strongest = outline(*line.strongest, line);
      // Lines without an outline count, too: it is a share of all lines that
      // has to agree.
      offsets.strongest.push_back(
          at_strongest.value_or(line.strongest->steepest) - line.border);
    }
    if (line.nearest) {
      const bool is_strongest =
          line.strongest && line.strongest->sample == line.nearest->sample;
      if (const auto position =
              is_strongest ? at_strongest : outline(*line.nearest, line)) {
        offsets.nearest.push_back(*position - line.border);
      }
    }
  }
  return offsets;
}

}  // namespace octacut
