#include "core/views/border_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

// The largest shift, in pixels, that edges may cause if the strongest ones and
// the nearest ones do not agree to half a pixel: masks differ by it that cover
// each pixel which the object touches, or only those that it fills. Larger
// shifts are then left to the offsets of refinement.
constexpr float kMaxDoubtfulShift = 1;
// The largest shift at all. At the end of the range, edges of larger shifts are
// cut off, so that the rest of them would be taken for a peak.
constexpr float kMaxShift = kEdgeRange - 1;
constexpr double kMaxDisagreement = 0.5;
// The share of edges that agree, from which on the shift is known, and by how
// many pixels refinement may then move the borders from it: contours err more
// than edges do (docs/experiments/mask_borders.md).
constexpr double kMostEdges = 0.5;
constexpr float kContourSlack = 0.1f;

}  // namespace

std::optional<BorderEdges> MeasureBorderEdges(const ViewSet& views,
                                              const Context& context) {
  const std::vector<OutlineFit> fits(kOutlineBlurs.begin(),
                                     kOutlineBlurs.end());
  std::vector<EdgeOffsets> of_views(views.size());
  ParallelFor(context, views.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (views[i].pyramid.NumLevels() > 0) {
        of_views[i] = FindEdgeOffsets(views[i], fits);
      }
    }
  });
  EdgeOffsets offsets;
  const auto append = [](const std::vector<float>& from,
                         std::vector<float>* to) {
    to->insert(to->end(), from.begin(), from.end());
  };
  for (const EdgeOffsets& of_view : of_views) {
    append(of_view.strongest, &offsets.strongest);
    append(of_view.nearest, &offsets.nearest);
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
  return BorderEdges{.shift = nearest->center,
                     .deviation = nearest->deviation,
                     .share = strongest->share,
                     .strongest_shift = strongest->center};
}

std::optional<BorderEdges> ShiftBordersToEdges(const Context& context,
                                               ViewSet* views) {
  const std::optional<BorderEdges> edges = MeasureBorderEdges(*views, context);
  const double disagreement =
      edges ? std::abs(edges->shift - edges->strongest_shift) : 0;
  const double limit =
      disagreement < kMaxDisagreement ? kMaxShift : kMaxDoubtfulShift;
  // The share is that of the strongest edges: it says nothing where those lie
  // elsewhere.
  const bool is_known = edges && edges->share >= kMostEdges &&
                        disagreement < 1 && std::abs(edges->shift) < limit;
  for (PreparedView& view : *views) {
    view.border_shift =
        edges ? float(std::clamp(edges->shift, -limit, limit)) : 0;
    view.border_shift_slack =
        is_known ? kContourSlack : std::numeric_limits<float>::infinity();
  }
  return edges;
}

void KeepBorders(ViewSet* views) {
  for (PreparedView& view : *views) {
    view.border_shift = 0;
    view.border_shift_slack = 0;
  }
}

}  // namespace octacut
