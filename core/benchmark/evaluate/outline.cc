#include "core/benchmark/evaluate/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/scene/pixel_distance.h"
#include "core/scene/scene.h"

namespace octacut {
namespace {

constexpr double kHalf = kObjectThreshold - 0.5;

double DistanceToSegment(const Eigen::Vector2d& point,
                         const OutlineSegment& segment) {
  const Eigen::Vector2d along = segment.end - segment.begin;
  const double squared = along.squaredNorm();
  const double t =
      squared > 0
          ? std::clamp((point - segment.begin).dot(along) / squared, 0.0, 1.0)
          : 0.0;
  return (point - segment.begin - t * along).norm();
}

}  // namespace

Outline::Outline(const cv::Mat& coverage)
    : num_columns_(std::max(0, coverage.cols - 1)),
      num_rows_(std::max(0, coverage.rows - 1)) {
  cv::Mat is_free(num_rows_, num_columns_, CV_8UC1);
  for (int y = 0; y < num_rows_; ++y) {
    for (int x = 0; x < num_columns_; ++x) {
      first_.push_back(static_cast<uint32_t>(segments_.size()));
      AddCell(coverage, x, y);
      is_free.at<uint8_t>(y, x) = segments_.size() == first_.back();
    }
  }
  first_.push_back(static_cast<uint32_t>(segments_.size()));
  if (!segments_.empty()) {
    to_nearest_ = DistancesToZero(is_free);
  }
}

void Outline::AddCell(const cv::Mat& coverage, int x, int y) {
  // Around the cell; edge k lies between corners k and k + 1.
  static constexpr int kCorners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::array<double, 4> values;
  double mean = 0;
  for (int k = 0; k < 4; ++k) {
    values[k] =
        coverage.at<uint8_t>(y + kCorners[k][1], x + kCorners[k][0]) - kHalf;
    mean += values[k] / 4;
  }
  std::array<Eigen::Vector2d, 4> crossings;
  int count = 0;
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    if ((values[k] > 0) != (values[next] > 0)) {
      const double t = values[k] / (values[k] - values[next]);
      crossings[count++] = {
          x + 0.5 + kCorners[k][0] + t * (kCorners[next][0] - kCorners[k][0]),
          y + 0.5 + kCorners[k][1] + t * (kCorners[next][1] - kCorners[k][1])};
    }
  }
  if (count == 2) {
    segments_.push_back({crossings[0], crossings[1]});
  } else if (count == 4) {
    // The cell's middle goes with corners 0 and 2, or with 1 and 3: then each
    // segment cuts off one of the others.
    const bool around_first = (values[0] > 0) != (mean > 0);
    segments_.push_back(
        {crossings[around_first ? 3 : 0], crossings[around_first ? 0 : 1]});
    segments_.push_back(
        {crossings[around_first ? 1 : 2], crossings[around_first ? 2 : 3]});
  }
}

double Outline::Distance(const Eigen::Vector2d& point) const {
  double best = std::numeric_limits<double>::infinity();
  if (segments_.empty()) {
    return best;
  }
  const int x = std::clamp(int(point.x() - 0.5), 0, num_columns_ - 1);
  const int y = std::clamp(int(point.y() - 0.5), 0, num_rows_ - 1);
  // Point and segments may be anywhere in their cells.
  const int reach = int(to_nearest_.at<float>(y, x) + 2 * std::sqrt(2.0)) + 1;
  for (int v = std::max(0, y - reach); v <= std::min(num_rows_ - 1, y + reach);
       ++v) {
    for (int u = std::max(0, x - reach);
         u <= std::min(num_columns_ - 1, x + reach);
         ++u) {
      const size_t cell = size_t(v) * num_columns_ + u;
      for (uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
        best = std::min(best, DistanceToSegment(point, segments_[i]));
      }
    }
  }
  return best;
}

}  // namespace octacut
