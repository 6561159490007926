#include "core/views/border_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/views/border_lines.h"
#include "core/views/edge_offsets.h"
#include "core/views/offset_peak.h"

namespace octacut {
namespace {

// Edges at any point at all would lie within a pixel of the peak with a share
// of one sixth.
constexpr double kMinShare = 1.0 / 3;

// The largest shift in pixels that edges may cause if it is doubted, or the
// strongest and the nearest ones do not agree to half a pixel: masks differ by
// it that cover each pixel which the object touches, or only those that it
// fills. Larger shifts are then left to the offsets of refinement.
constexpr float kMaxDoubtfulShift = 1;
// The largest one at all. At the end of the range, edges of larger shifts are
// cut off, so that the rest of them would be taken for a peak.
constexpr float kMaxShift = kEdgeRange - 1;
constexpr double kMaxDisagreement = 0.5;
// The share of edges that agree, from which on the shift is known, and by how
// many pixels refinement may then move the borders from it: contours err more
// than edges do (docs/experiments/mask_borders.md).
constexpr double kMostEdges = 0.5;
constexpr float kContourSlack = 0.1f;
// Edges per view that are enough to show an outline, if there is one.
constexpr size_t kManyEdges = 100;

void Append(const std::vector<float>& from, std::vector<float>* to) {
  to->insert(to->end(), from.begin(), from.end());
}

EdgePositions EdgesOfAll(const ViewSet& views, const Context& context) {
  EdgePositions edges;
  for (const EdgePositions& of_view : FindEdgesOfViews(views, context)) {
    Append(of_view.all, &edges.all);
    Append(of_view.comparable, &edges.comparable);
    edges.num_lines += of_view.num_lines;
  }
  return edges;
}

double Disagreement(const BorderEdges& edges) {
  return std::abs(edges.shift - edges.strongest_shift);
}

// Whether the strongest edges and the nearest ones agree on less than `limit`.
bool AgreeOnLessThan(float limit, const std::optional<BorderEdges>& edges) {
  return edges && Disagreement(*edges) < kMaxDisagreement &&
         std::abs(edges->shift) < limit;
}

}  // namespace

std::optional<BorderEdges> MeasureBorderEdges(const ViewSet& views,
                                              const Context& context) {
  const std::vector<OutlineFit> fits(kOutlineBlurs.begin(),
                                     kOutlineBlurs.end());
  std::vector<EdgeOffsets> of_views(views.size());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    if (views[i].pyramid.NumLevels() > 0) {
      of_views[i] = FindEdgeOffsets(views[i], fits);
    }
  });
  EdgeOffsets offsets;
  for (const EdgeOffsets& of_view : of_views) {
    Append(of_view.strongest, &offsets.strongest);
    Append(of_view.nearest, &offsets.nearest);
    Append(of_view.alone, &offsets.alone);
  }
  // The nearest of many random edges is near, so the strongest ones say whether
  // there is a peak.
  const std::optional<OffsetPeak> strongest =
      FindOffsetPeak(offsets.strongest, kMinShare);
  const std::optional<OffsetPeak> nearest =
      strongest ? FindOffsetPeak(offsets.nearest, 0) : std::nullopt;
  if (!nearest) {
    return std::nullopt;
  }
  // Those that stand alone say more exactly where it is: of a thin line of
  // light, which gloss shows along an outline, the steepest point is up to 0.4
  // pixels outside the object (docs/experiments/mask_borders.md).
  const OffsetPeak outline =
      PeakAround(nearest->center, offsets.alone).value_or(*nearest);
  return BorderEdges{.shift = outline.center,
                     .deviation = outline.deviation,
                     .share = strongest->share,
                     .strongest_shift = strongest->center};
}

CoarseShift FindLargeShift(const ViewSet& views,
                           const std::optional<BorderEdges>& edges,
                           const Context& context) {
  if (AgreeOnLessThan(kMinCoarseShift, edges)) {
    return {};
  }
  const EdgePositions all_edges = EdgesOfAll(views, context);
  CoarseShift coarse = FindCoarseShift(all_edges);
  if (coarse.shift && (std::abs(*coarse.shift) <= kMinCoarseShift ||
                       AgreeOnLessThan(kMaxShift, edges))) {
    coarse.shift = std::nullopt;
  }
  if (!edges && !coarse.shift &&
      all_edges.comparable.size() >= kManyEdges * views.size()) {
    context.Warn(fmt::format(
        "Look at the masks: within {} pixels of their borders, the photographs "
        "show edges, but no outline of an object. If the masks are right, the "
        "object looks much like its background, and the borders of the masks "
        "cannot be checked.",
        kWideEdgeRange));
  }
  return coarse;
}

void ShiftBordersToEdges(const std::optional<BorderEdges>& edges,
                         bool is_doubted,
                         ViewSet* views) {
  float shift = 0;
  float slack = std::numeric_limits<float>::infinity();
  if (edges) {
    const double limit = !is_doubted && Disagreement(*edges) < kMaxDisagreement
                             ? kMaxShift
                             : kMaxDoubtfulShift;
    shift = float(std::clamp(edges->shift, -limit, limit));
    // The share is that of the strongest edges: it says nothing where those lie
    // elsewhere.
    if (edges->share >= kMostEdges && Disagreement(*edges) < 1 &&
        std::abs(edges->shift) < limit) {
      slack = kContourSlack;
    }
  }
  for (PreparedView& view : *views) {
    view.border_shift = shift;
    view.border_shift_slack = slack;
  }
}

void KeepBorders(ViewSet* views) {
  for (PreparedView& view : *views) {
    view.border_shift = 0;
    view.border_shift_slack = 0;
  }
}

}  // namespace octacut
