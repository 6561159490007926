// One view and one neighbour of core/benchmark/evaluate/reprojection.h. For
// that alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "core/benchmark/evaluate/reprojection.h"

namespace octacut {

inline constexpr int kCorrelationBins = 2000;  // over -1 .. 1

struct PairSums {
  size_t num_whole = 0;    // windows that both views see
  size_t num_windows = 0;  // of these not plain
  double sum = 0;          // of their correlations
  std::array<uint32_t, kCorrelationBins> histogram{};
};

// A view with what is needed of it; `grey` and `depth` CV_32FC1.
struct GreyView {
  const View& view;
  const cv::Mat& grey;
  const cv::Mat& depth;
};

// Correlates the windows of `view` with the image of `neighbor`, reprojected
// over the surface that the depths show. `compared` (CV_8UC1, of the view's
// size) becomes 1 in the middle of every whole window. `correlations`, unless
// null, gets the sums of the correlations and their number at the middle of
// every window that is not plain: CV_32FC2, of the view's size.
PairSums CompareWithNeighbor(const GreyView& view,
                             const GreyView& neighbor,
                             cv::Mat* compared,
                             cv::Mat* correlations = nullptr);

}  // namespace octacut
