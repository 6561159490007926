#include "core/evidence/pick_depths.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parabola.h"

namespace octacut {
namespace {

// The best plane of a ray, refined by a parabola; 0 when it does not stand
// out from every other peak. `scores` has one element a plane.
float PickDepth(const std::vector<float>& scores,
                const ScoreVolume& volume,
                float min_score) {
  // A second peak that is less than this below the best one makes the depth
  // ambiguous; planes on both sides of the best one belong to its own peak. Not
  // varied alone.
  constexpr float kPeakMargin = 0.03f;
  constexpr int kPeakWidth = 3;
  const int n = volume.num_planes;
  const int best =
      int(std::max_element(scores.begin(), scores.end()) - scores.begin());
  if (scores[best] < min_score) {
    return 0;
  }
  for (int i = 0; i < n; ++i) {
    if (std::abs(i - best) > kPeakWidth &&
        scores[i] > scores[best] - kPeakMargin) {
      return 0;
    }
  }
  float offset = 0;
  if (best > 0 && best + 1 < n && scores[best - 1] > -1 &&
      scores[best + 1] > -1) {
    offset = ParabolaExtremum(scores[best - 1], scores[best], scores[best + 1]);
  }
  return volume.first_depth +
         (float(best) + std::clamp(offset, -0.5f, 0.5f)) * volume.spacing;
}

}  // namespace

SweptDepthMap PickDepths(const SweepView& view,
                         const ScoreVolume& volume,
                         float min_score) {
  SweptDepthMap map;
  map.width = view.grey.cols;
  map.height = view.grey.rows;
  map.scale = view.scale;
  map.depths.assign(size_t(map.width) * map.height, 0);
  std::vector<float> scores(volume.num_planes);
  const cv::Rect& frame = volume.frame;
  size_t ray = 0;
  for (int y = frame.y; y < frame.y + frame.height; ++y) {
    for (int x = frame.x; x < frame.x + frame.width; ++x, ++ray) {
      for (int plane = 0; plane < volume.num_planes; ++plane) {
        scores[plane] = volume.scores[plane * volume.num_rays + ray];
      }
      map.depths[size_t(y) * map.width + x] =
          PickDepth(scores, volume, min_score);
    }
  }
  return map;
}

}  // namespace octacut
