#include "core/evidence/mask_confidence.h"

#include "core/base/parallel.h"
#include "core/base/ramp.h"

namespace octacut {
namespace {

// Shares of the points near a border that lie outside of it: up to the first
// the mask is relied upon, from the second on it is not.
constexpr float kSureShare = 0.36f;
constexpr float kDoubtfulShare = 0.42f;
// Points that every view is given inside of its border: few tell nothing.
constexpr float kPriorPoints = 100;

struct BorderPoints {
  size_t inside = 0;
  size_t outside = 0;
};

void CountPoint(const PreparedView& view,
                const Eigen::Vector3f& point,
                BorderPoints* count) {
  const std::optional<ProjectedPoint> p = view.projection.Project(point);
  if (!p) {
    return;
  }
  const float u = p->u;
  const float v = p->v;
  const float reach = view.mask_tolerance;
  // Where the frame cuts the object off the mask has no border.
  if (!view.projection.InFrame(u - reach, v - reach) ||
      !view.projection.InFrame(u + reach, v + reach)) {
    return;
  }
  const Containment pixel = view.silhouette.Test(u, v, u, v);
  if (pixel == Containment::kObject) {
    count->inside +=
        view.silhouette.Test(u - reach, v - reach, u + reach, v + reach) ==
        Containment::kMixed;
  } else if (pixel == Containment::kBackground) {
    count->outside +=
        view.silhouette.Test(u, v, u, v, reach) == Containment::kMixed;
  }
}

BorderPoints CountBorderPoints(const ViewSet& views,
                               const std::vector<SweptDepthMap>& maps,
                               size_t judged) {
  BorderPoints count;
  for (size_t i = 0; i < views.size(); ++i) {
    if (i == judged) {
      continue;  // its own depths end where its mask does
    }
    const ViewProjection& projection = views[i].projection;
    ForEachDepth(maps[i],
                 projection,
                 [&](int, int, float depth, const Eigen::Vector3f& ray) {
                   CountPoint(
                       views[judged], projection.center + depth * ray, &count);
                 });
  }
  return count;
}

}  // namespace

std::vector<float> EstimateMaskConfidence(
    const ViewSet& views,
    const std::vector<SweptDepthMap>& maps,
    const Context& context) {
  std::vector<float> confidence(views.size(), 1.0f);
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    if (views[i].mask_tolerance == 0) {
      return;
    }
    const BorderPoints count = CountBorderPoints(views, maps, i);
    const float share = float(count.outside) /
                        (float(count.inside + count.outside) + kPriorPoints);
    confidence[i] = Ramp(share, kDoubtfulShare, kSureShare);
  });
  return confidence;
}

}  // namespace octacut
