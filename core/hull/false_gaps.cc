#include "core/hull/false_gaps.h"

#include <set>
#include <utility>

#include "core/base/median.h"
#include "core/base/parallel.h"
#include "core/hull/mask_gaps.h"
#include "core/hull/visual_hull.h"
#include "core/views/line_of_sight.h"
#include "core/views/view_set.h"

namespace octacut {
namespace {

// What others leave of the gap, over what they leave of what is around it.
constexpr double kMinLeftOfEnclosed = 0.5;
constexpr double kMinLeftOfBay = 0.7;
// A gap that is filled may show that one of another view is false, too: rounds
// end when no more are, or after so many.
constexpr int kMaxRounds = 5;
// Lines of sight that are tried a gap, and points of each an edge of the root
// cube.
constexpr size_t kMaxLines = 16;
constexpr int kPointsPerEdge = 128;

struct GapOfView {
  size_t view;
  MaskGap gap;
  bool is_false = false;
};

bool IsLeftByOthers(const ViewSet& views,
                    size_t view,
                    const Eigen::Vector3f& point) {
  for (size_t other = 0; other < views.size(); ++other) {
    if (other != view && ShowsBackground(views[other], point)) {
      return false;
    }
  }
  return true;
}

// Points that all other views leave of a line of sight within the root cube.
int CountLeft(const ViewSet& views, size_t view, const Eigen::Vector2f& pixel) {
  const ViewProjection& projection = views[view].projection;
  const Eigen::Vector3f direction =
      (projection.RaysOfPixels() * pixel.homogeneous()).normalized();
  int num_left = 0;
  for (const Eigen::Vector3f& point :
       PointsOnLine(projection.center, direction, kPointsPerEdge)) {
    num_left += IsLeftByOthers(views, view, point);
  }
  return num_left;
}

// Over some of the pixels.
double MedianLeft(const ViewSet& views,
                  size_t view,
                  const std::vector<Eigen::Vector2f>& pixels) {
  const size_t stride = (pixels.size() + kMaxLines - 1) / kMaxLines;
  std::vector<int> left;
  for (size_t i = 0; i < pixels.size(); i += stride) {
    left.push_back(CountLeft(views, view, pixels[i]));
  }
  return Median(std::move(left));
}

bool IsFalse(const ViewSet& views, const GapOfView& candidate) {
  if (candidate.gap.ring.empty()) {
    return false;
  }
  const double left = MedianLeft(views, candidate.view, candidate.gap.middle);
  const double around = MedianLeft(views, candidate.view, candidate.gap.ring);
  const double min_share =
      candidate.gap.is_enclosed ? kMinLeftOfEnclosed : kMinLeftOfBay;
  return left > 0 && left >= min_share * around;
}

std::vector<GapOfView> FindCandidates(const Scene& scene,
                                      double mask_tolerance,
                                      const Context& context,
                                      Phase* phase) {
  std::vector<std::vector<MaskGap>> of_views(scene.views.size());
  ParallelEach(context, of_views.size(), 1, [&](size_t v) {
    const View& view = scene.views[v];
    of_views[v] = FindMaskGaps(view.mask, mask_tolerance * view.scale);
    phase->Advance();
  });
  std::vector<GapOfView> candidates;
  for (size_t v = 0; v < of_views.size(); ++v) {
    for (MaskGap& gap : of_views[v]) {
      candidates.push_back({v, std::move(gap)});
    }
  }
  return candidates;
}

ViewSet PrepareSilhouettes(Scene scene,
                           const BoundingCube& cube,
                           const Context& context) {
  for (View& view : scene.views) {
    view.image = cv::Mat();
  }
  return PrepareViews(scene, cube, context);
}

// Fills what is false and takes it from the candidates.
void FillFalse(std::vector<GapOfView>* candidates,
               ViewSet* views,
               RepairedScene* filled) {
  std::set<size_t> changed;
  for (const GapOfView& candidate : *candidates) {
    if (candidate.is_false) {
      cv::Mat& mask = filled->scene.views[candidate.view].mask;
      if (changed.insert(candidate.view).second) {
        mask = mask.clone();
      }
      FillGap(candidate.gap, &mask);
      filled->gaps.push_back({candidate.view, candidate.gap.num_pixels});
    }
  }
  for (const size_t view : changed) {
    const View& repaired = filled->scene.views[view];
    (*views)[view].silhouette = Silhouette(repaired.mask, repaired.unknown);
  }
  std::erase_if(*candidates,
                [](const GapOfView& candidate) { return candidate.is_false; });
}

}  // namespace

RepairedScene FillFalseGaps(const Scene& scene,
                            const BoundingCube& cube,
                            double mask_tolerance,
                            const Context& context) {
  RepairedScene filled{scene, {}};
  Phase phase(context, "search for gaps in the masks", scene.views.size());
  std::vector<GapOfView> candidates =
      FindCandidates(scene, mask_tolerance, context, &phase);
  if (candidates.empty()) {
    return filled;
  }
  ViewSet views = PrepareSilhouettes(scene, cube, context);
  for (int round = 0; round < kMaxRounds; ++round) {
    const size_t before = filled.gaps.size();
    ParallelEach(context, candidates.size(), 1, [&](size_t i) {
      candidates[i].is_false = IsFalse(views, candidates[i]);
    });
    FillFalse(&candidates, &views, &filled);
    if (filled.gaps.size() == before || candidates.empty()) {
      break;
    }
  }
  ReportGaps(filled, "other views show the object", context);
  return filled;
}

}  // namespace octacut
