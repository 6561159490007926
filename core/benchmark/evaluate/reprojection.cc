#include "core/benchmark/evaluate/reprojection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/benchmark/evaluate/reprojection_pair.h"

namespace octacut {

void ReprojectionOptions::Check() const {
  CheckOption(
      num_neighbors >= 1, "num_neighbors", num_neighbors, "must be positive");
  CheckOption(min_angle > 0 && min_angle < max_angle,
              "min_angle",
              min_angle,
              "must be in (0, max_angle)");
  CheckOption(max_angle <= 120, "max_angle", max_angle, "must be at most 120");
}

std::vector<std::vector<size_t>> ReprojectionNeighbors(
    const std::vector<View>& views,
    const Eigen::Vector3d& middle,
    const ReprojectionOptions& options) {
  std::vector<Eigen::Vector3d> directions;
  directions.reserve(views.size());
  for (const View& view : views) {
    directions.push_back((view.Center() - middle).normalized());
  }
  std::vector<std::vector<size_t>> neighbors(views.size());
  for (size_t i = 0; i < views.size(); ++i) {
    std::vector<std::pair<double, size_t>> candidates;
    for (size_t j = 0; j < views.size(); ++j) {
      const double cosine =
          std::clamp(directions[i].dot(directions[j]), -1.0, 1.0);
      const double angle = std::acos(cosine) * 180 / std::numbers::pi;
      if (j != i && angle >= options.min_angle && angle <= options.max_angle) {
        candidates.emplace_back(angle, j);
      }
    }
    std::sort(candidates.begin(), candidates.end());
    candidates.resize(
        std::min(candidates.size(), size_t(options.num_neighbors)));
    for (const auto& [angle, j] : candidates) {
      neighbors[i].push_back(j);
    }
  }
  return neighbors;
}

namespace {

// The correlation below which a tenth of the windows lie.
double TenthFromBelow(const std::array<uint64_t, kCorrelationBins>& histogram,
                      size_t total) {
  uint64_t sum = 0;
  for (int bin = 0; bin < kCorrelationBins; ++bin) {
    sum += histogram[bin];
    if (10 * sum >= total) {
      return 2 * (bin + 0.5) / kCorrelationBins - 1;
    }
  }
  return 1;
}

// The means of CV_32FC2 sums and numbers.
cv::Mat MeanMap(const cv::Mat& sums) {
  cv::Mat means(sums.size(), CV_32FC1);
  for (int y = 0; y < sums.rows; ++y) {
    for (int x = 0; x < sums.cols; ++x) {
      const cv::Vec2f& sum = sums.at<cv::Vec2f>(y, x);
      means.at<float>(y, x) = sum[1] > 0
                                  ? sum[0] / sum[1]
                                  : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return means;
}

struct ViewSums {
  std::vector<PairSums> pairs;
  size_t mesh_pixels = 0;
  size_t compared_pixels = 0;
};

Reprojection Combine(const std::vector<ViewSums>& sums) {
  Reprojection result;
  std::array<uint64_t, kCorrelationBins> histogram{};
  size_t num_whole = 0;
  size_t mesh_pixels = 0;
  size_t compared_pixels = 0;
  double sum = 0;
  for (const ViewSums& view : sums) {
    mesh_pixels += view.mesh_pixels;
    compared_pixels += view.compared_pixels;
    for (const PairSums& pair : view.pairs) {
      ++result.num_pairs;
      num_whole += pair.num_whole;
      result.num_windows += pair.num_windows;
      sum += pair.sum;
      for (int bin = 0; bin < kCorrelationBins; ++bin) {
        histogram[bin] += pair.histogram[bin];
      }
    }
  }
  const auto share = [](double part, size_t whole) {
    return whole > 0 ? part / double(whole) : 0;
  };
  result.mean_correlation = share(sum, result.num_windows);
  result.percentile_10 = result.num_windows > 0
                             ? TenthFromBelow(histogram, result.num_windows)
                             : 0;
  result.plain_fraction =
      share(double(num_whole - result.num_windows), num_whole);
  result.compared_fraction = share(double(compared_pixels), mesh_pixels);
  return result;
}

}  // namespace

Reprojection MeasureReprojection(const std::vector<View>& views,
                                 const std::vector<cv::Mat>& depths,
                                 const Eigen::Vector3d& middle,
                                 const ReprojectionOptions& options,
                                 const Context& context) {
  options.Check();
  std::vector<cv::Mat> greys;
  for (const View& view : views) {
    if (view.image.empty()) {
      throw InputError(
          fmt::format("reprojection: view {} has no image", view.name));
    }
    cv::Mat grey;
    cv::cvtColor(view.image, grey, cv::COLOR_BGR2GRAY);
    grey.convertTo(greys.emplace_back(), CV_32FC1);
  }
  const auto neighbors = ReprojectionNeighbors(views, middle, options);
  std::vector<ViewSums> sums(views.size());
  std::vector<cv::Mat> maps(options.keep_maps ? views.size() : 0);
  Phase phase(context, "reprojection", views.size());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    cv::Mat compared = cv::Mat::zeros(depths[i].size(), CV_8UC1);
    cv::Mat correlations;
    if (options.keep_maps) {
      correlations = cv::Mat::zeros(depths[i].size(), CV_32FC2);
    }
    for (const size_t j : neighbors[i]) {
      sums[i].pairs.push_back(
          CompareWithNeighbor({views[i], greys[i], depths[i]},
                              {views[j], greys[j], depths[j]},
                              &compared,
                              options.keep_maps ? &correlations : nullptr));
    }
    if (options.keep_maps) {
      maps[i] = MeanMap(correlations);
    }
    sums[i].mesh_pixels = size_t(cv::countNonZero(depths[i] > 0));
    sums[i].compared_pixels = size_t(cv::countNonZero(compared));
    phase.Advance();
  });
  Reprojection result = Combine(sums);
  result.maps = std::move(maps);
  return result;
}

}  // namespace octacut
