#include "core/benchmark/evaluate/reprojection_pair.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace octacut {
namespace {

// Pixels of the neighbour by which a point may lie behind its surface: as much
// as a surface at some 70 degrees falls off across a pixel.
constexpr double kDepthTolerance = 3;

// Grey level and least depth around a pixel of an image. False where it is not
// among four pixels that the mesh covers.
bool SampleCovered(const cv::Mat& grey,
                   const cv::Mat& depth,
                   const Eigen::Vector2d& pixel,
                   double* value,
                   double* least_depth) {
  const double x = pixel.x() - 0.5;
  const double y = pixel.y() - 0.5;
  if (!(x >= 0 && y >= 0 && x < grey.cols - 1 && y < grey.rows - 1)) {
    return false;
  }
  const int u = int(x);
  const int v = int(y);
  const float* depths[2] = {depth.ptr<float>(v) + u,
                            depth.ptr<float>(v + 1) + u};
  *least_depth =
      std::min({depths[0][0], depths[0][1], depths[1][0], depths[1][1]});
  const float* values[2] = {grey.ptr<float>(v) + u, grey.ptr<float>(v + 1) + u};
  const double top = values[0][0] + (x - u) * (values[0][1] - values[0][0]);
  const double bottom = values[1][0] + (x - u) * (values[1][1] - values[1][0]);
  *value = top + (y - v) * (bottom - top);
  return *least_depth > 0;
}

// The neighbour's grey levels at the pixels of `view`, with `seen` 1 where both
// see the same point and 0, like the grey level, elsewhere. CV_64F both.
struct Warped {
  cv::Mat values;
  cv::Mat seen;
};

Warped WarpOverMesh(const GreyView& from, const GreyView& to) {
  const View& view = from.view;
  const View& neighbor = to.view;
  const cv::Mat& depth = from.depth;
  const Rigid3d world_from_view = view.cam_from_world.Inverse();
  const Eigen::Matrix3d rotation =
      neighbor.cam_from_world.rotation * world_from_view.rotation;
  const Eigen::Vector3d translation =
      neighbor.cam_from_world * world_from_view.translation;
  const double tolerance = kDepthTolerance / neighbor.camera.fx;
  Warped warped{cv::Mat::zeros(depth.size(), CV_64FC1),
                cv::Mat::zeros(depth.size(), CV_64FC1)};
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      const double z = depth.at<float>(y, x);
      if (z <= 0) {
        continue;
      }
      const Eigen::Vector3d point =
          rotation * (z * view.camera.Unproject({x + 0.5, y + 0.5})) +
          translation;
      double value;
      double least_depth;
      if (point.z() > 0 &&
          SampleCovered(to.grey,
                        to.depth,
                        neighbor.camera.Project(point),
                        &value,
                        &least_depth) &&
          point.z() <= least_depth + tolerance * point.z()) {
        warped.values.at<double>(y, x) = value;
        warped.seen.at<double>(y, x) = 1;
      }
    }
  }
  return warped;
}

cv::Mat WindowSum(const cv::Mat& values, int radius) {
  const int side = 2 * radius + 1;
  cv::Mat sums;
  cv::boxFilter(
      values, sums, CV_64F, {side, side}, {-1, -1}, false, cv::BORDER_CONSTANT);
  return sums;
}

}  // namespace

PairSums CompareWithNeighbor(const GreyView& view,
                             const GreyView& neighbor,
                             cv::Mat* compared,
                             cv::Mat* correlations) {
  const Warped warped = WarpOverMesh(view, neighbor);
  const int radius = ReprojectionOptions::kWindowRadius;
  const double count = (2 * radius + 1) * (2 * radius + 1);
  cv::Mat own;
  view.grey.convertTo(own, CV_64F);
  own = own.mul(warped.seen);
  const cv::Mat& other = warped.values;
  const cv::Mat num_seen = WindowSum(warped.seen, radius);
  const cv::Mat sum_a = WindowSum(own, radius);
  const cv::Mat sum_b = WindowSum(other, radius);
  const cv::Mat sum_aa = WindowSum(own.mul(own), radius);
  const cv::Mat sum_bb = WindowSum(other.mul(other), radius);
  const cv::Mat sum_ab = WindowSum(own.mul(other), radius);
  const double least =
      ReprojectionOptions::kMinContrast * ReprojectionOptions::kMinContrast;
  PairSums result;
  for (int y = 0; y < own.rows; ++y) {
    for (int x = 0; x < own.cols; ++x) {
      if (num_seen.at<double>(y, x) < count - 0.5) {
        continue;
      }
      ++result.num_whole;
      compared->at<uint8_t>(y, x) = 1;
      const double mean_a = sum_a.at<double>(y, x) / count;
      const double mean_b = sum_b.at<double>(y, x) / count;
      const double aa = sum_aa.at<double>(y, x) / count - mean_a * mean_a;
      const double bb = sum_bb.at<double>(y, x) / count - mean_b * mean_b;
      const double ab = sum_ab.at<double>(y, x) / count - mean_a * mean_b;
      if (aa <= least) {
        continue;
      }
      // A neighbour that is plain where the view is not disagrees with it.
      const double correlation =
          std::clamp(ab / std::sqrt(aa * std::max(bb, 1e-9)), -1.0, 1.0);
      ++result.num_windows;
      result.sum += correlation;
      if (correlations != nullptr) {
        correlations->at<cv::Vec2f>(y, x) += cv::Vec2f(float(correlation), 1);
      }
      ++result.histogram[std::min(
          kCorrelationBins - 1, int((correlation + 1) / 2 * kCorrelationBins))];
    }
  }
  return result;
}

}  // namespace octacut
