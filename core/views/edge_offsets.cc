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

// With more blur, photographs out of focus, whose blur is no Gaussian, seem to
// have outlines farther outside (docs/experiments/mask_borders.md).
constexpr double kMaxWideBlur = 0.75;

// How outlines are looked for.
struct OutlineSearch {
  const OutlineFit* fit;
  bool is_wide;  // OutlineFit::Find
};

// The variance that a blur leaves in the better half of the lines, as a share.
double ResidualShare(const OutlineSearch& search,
                     const std::vector<BorderLine>& lines) {
  const size_t stride = lines.size() / kMaxBlurLines + 1;
  std::vector<float> shares;
  for (size_t i = 0; i < lines.size(); i += stride) {
    if (lines[i].strongest) {
      const auto fitted = search.fit->Find(
          lines[i].light, lines[i].strongest->sample, search.is_wide);
      shares.push_back(fitted ? fitted->residual_share : 1);
    }
  }
  std::sort(shares.begin(), shares.end());
  return std::accumulate(
      shares.begin(), shares.begin() + std::ptrdiff_t(shares.size() / 2), 0.0);
}

// That of the blur with which outlines fit best. On many lines something else
// is near, so the better half of them decides.
OutlineSearch SearchOfBlur(const std::vector<BorderLine>& lines,
                           std::span<const OutlineFit> fits,
                           bool is_wide) {
  std::vector<double> left;
  for (const OutlineFit& fit : fits) {
    left.push_back(ResidualShare({&fit, is_wide}, lines));
  }
  const auto best = std::min_element(left.begin(), left.end()) - left.begin();
  return {&fits[size_t(best)], is_wide};
}

// Pixels from the middle; none if the line has no outline at the edge.
std::optional<float> OutlineAt(const BorderEdge& edge,
                               const BorderLine& line,
                               const OutlineSearch& search) {
  const auto fitted = search.fit->Find(line.light, edge.sample, search.is_wide);
  if (!fitted || !fitted->position) {
    return std::nullopt;
  }
  return PixelsFromMiddle(*fitted->position);
}

// Whether most edges that stand alone have an outline.
bool FindsMost(const OutlineSearch& search,
               const std::vector<BorderLine>& lines) {
  size_t count = 0;
  size_t num_found = 0;
  for (const BorderLine& line : lines) {
    if (line.strongest && line.strongest->stands_alone) {
      ++count;
      num_found += OutlineAt(*line.strongest, line, search) ? 1 : 0;
    }
  }
  return 2 * num_found > count;
}

// A search that finds most outlines; none where the blur is not known. Large,
// smooth surfaces that mirror the background at grazing angles have their edges
// farther inside.
std::optional<OutlineSearch> SearchForOutlines(
    const std::vector<BorderLine>& lines, std::span<const OutlineFit> fits) {
  const OutlineSearch near = SearchOfBlur(lines, fits, false);
  if (near.fit->Blur() < kLeastUnknownBlur && FindsMost(near, lines)) {
    return near;
  }
  const OutlineSearch wide = SearchOfBlur(lines, fits, true);
  if (std::max(near.fit->Blur(), wide.fit->Blur()) < kMaxWideBlur &&
      FindsMost(wide, lines)) {
    return wide;
  }
  return std::nullopt;
}

}  // namespace

EdgeOffsets FindEdgeOffsets(const PreparedView& view,
                            std::span<const OutlineFit> fits) {
  const std::vector<BorderLine> lines = FindBorderLines(view);
  const std::optional<OutlineSearch> search = SearchForOutlines(lines, fits);
  // Where the blur is not known, or where a surface has other edges beside its
  // outline and does not just turn away, the steepest point is taken.
  const auto outline = [&](const BorderEdge& edge, const BorderLine& line) {
    return search && edge.stands_alone ? OutlineAt(edge, line, *search)
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
        if (line.nearest->stands_alone) {
          offsets.alone.push_back(offsets.nearest.back());
        }
      }
    }
  }
  return offsets;
}

}  // namespace octacut
