#include "core/segment/other_views.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

namespace octacut {
namespace {

// What the others hold for object need not be: they leave more than there is.
// So consensus on object counts by this much less than that on background.
constexpr float kInsideDoubt = 2;
// The consensus of the others below which a pixel cannot be object
// (docs/experiments/mask_excluded.md).
constexpr float kExcluded = -0.95f;
// Of what sure views say, so that it does not depend on how many they are; at
// most so much that two views could deny it, which tanh still tells from more.
constexpr float kSurelyShown = 0.5f;
constexpr float kShownToAll = 2 * kMaxViewLogOdds;

float ToConsensus(float log_odds) {
  return std::tanh(log_odds / kMaxViewLogOdds);
}

}  // namespace

cv::Mat ConsensusOfOthers(const OccupancyGrid& grid, size_t view) {
  cv::Mat others = grid.LogOddsOfOthers(view);
  for (float& value : cv::Mat_<float>(others)) {
    value = ToConsensus(value);
  }
  return others;
}

cv::Mat EvidenceOfOthers(const cv::Mat& others) {
  return kMaxViewLogOdds * others - kInsideDoubt * cv::max(others, 0);
}

cv::Mat ExcludedByOthers(const cv::Mat& others) { return others < kExcluded; }

cv::Mat ShownByOthers(const cv::Mat& others, size_t num_others) {
  const float of_sure = kSurelyShown * OccupancyGrid::LogOddsOfSure(num_others);
  return others > ToConsensus(std::min(of_sure, kShownToAll));
}

}  // namespace octacut
