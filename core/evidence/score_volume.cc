#include "core/evidence/score_volume.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/evidence/window_sums.h"

namespace octacut {
namespace {

// What one neighbour's correlation has to be better than the mean of several to
// count instead of it: the best of four chance correlations, whose deviation is
// 0.2 in windows of 25 samples, is as much above the mean of the best two.
constexpr float kBestAlone = 0.1f;

// Grey values are taken from their middle: small numbers keep the digits that
// a variance needs.
constexpr float kMiddleGrey = 128;

// The samples whose windows hold rays that meet the hull. The first row is a
// multiple of the windows' side: sums over windows are then rounded as if the
// frame was the whole view, wherever the hull is.
cv::Rect FrameOfHull(const SweepView& view, int radius) {
  const cv::Rect hull = cv::boundingRect(view.far_depth > 0);
  const int side = 2 * radius + 1;
  const int top = std::max(hull.y - radius, 0) / side * side;
  const cv::Rect frame(hull.x - radius,
                       top,
                       hull.width + 2 * radius,
                       hull.y + hull.height + radius - top);
  return frame & cv::Rect(cv::Point(0, 0), view.grey.size());
}

// Samples [begin, end) of a row of the frame whose rays meet the hull.
struct RowRange {
  int begin = 0;
  int end = 0;
};

std::vector<RowRange> HullRanges(const SweepView& view, const cv::Rect& frame) {
  std::vector<RowRange> ranges(frame.height);
  for (int y = 0; y < frame.height; ++y) {
    const float* far = view.far_depth[frame.y + y] + frame.x;
    int begin = frame.width;
    int end = 0;
    for (int x = 0; x < frame.width; ++x) {
      if (far[x] > 0) {
        begin = std::min(begin, x);
        end = x + 1;
      }
    }
    ranges[y] = {std::min(begin, end), end};
  }
  return ranges;
}

// Grey values of a neighbour where one row of the reference's rays meets the
// plane at `depth`.
class PlaneWarp {
 public:
  PlaneWarp(const SweepView& reference, const SweepView& neighbor, float depth)
      : neighbor_(neighbor), step_(1 / reference.scale) {
    homography_ = depth * (neighbor.projection->linear *
                           reference.projection->RaysOfPixels());
    epipole_ = neighbor.projection->Homogeneous(reference.projection->center);
  }

  // Of samples [begin, end).
  void Row(int y, int begin, int end, float* out) const {
    const float max_x = float(neighbor_.grey.cols - 1) - 0.001f;
    const float max_y = float(neighbor_.grey.rows - 1) - 0.001f;
    const float v = (float(y) + 0.5f) * step_;
    const Eigen::Vector3f row =
        homography_.col(1) * v + homography_.col(2) + epipole_;
    const Eigen::Vector3f column = homography_.col(0);
    const float* grey = neighbor_.grey[0];
    const size_t stride = neighbor_.grey.step1();
    for (int x = begin; x < end; ++x) {
      const float u = (float(x) + 0.5f) * step_;
      // Behind the neighbour's camera: some pixel, whatever it shows.
      const float depth = row.z() + column.z() * u;
      const float inverse = depth > 0 ? neighbor_.scale / depth : 0;
      const float sx =
          std::clamp((row.x() + column.x() * u) * inverse - 0.5f, 0.0f, max_x);
      const float sy =
          std::clamp((row.y() + column.y() * u) * inverse - 0.5f, 0.0f, max_y);
      const int x0 = int(sx);
      const int y0 = int(sy);
      const float fx = sx - float(x0);
      const float fy = sy - float(y0);
      const float* top = grey + size_t(y0) * stride + x0;
      const float* bottom = top + stride;
      const float upper = top[0] + (top[1] - top[0]) * fx;
      const float lower = bottom[0] + (bottom[1] - bottom[0]) * fx;
      *out++ = upper + (lower - upper) * fy - kMiddleGrey;
    }
  }

 private:
  const SweepView& neighbor_;
  float step_;
  Eigen::Matrix3f homography_;
  Eigen::Vector3f epipole_;
};

// The reference's grey values from the middle in its frame, with their window
// sums.
struct Reference {
  cv::Rect frame;
  std::vector<float> grey;
  std::vector<float> mean;
  std::vector<float> inverse_deviation;
  std::vector<RowRange> ranges;
  float plain_variance = 0;  // added to that of every window
};

Reference PrepareReference(const SweepView& view,
                           const DepthSweepOptions& options) {
  const int radius = DepthSweepOptions::kWindowRadius;
  Reference reference;
  reference.plain_variance =
      float(options.plain_deviation * options.plain_deviation);
  const cv::Rect frame = FrameOfHull(view, radius);
  reference.frame = frame;
  const size_t size = size_t(frame.area());
  reference.grey.resize(size);
  reference.mean.resize(size);
  reference.inverse_deviation.resize(size);
  reference.ranges = HullRanges(view, frame);
  WindowSums sums(frame.width, radius);
  for (int y = 0; y < frame.height + radius; ++y) {
    const int in = std::min(y, frame.height - 1);
    float* grey = reference.grey.data() + size_t(in) * frame.width;
    for (int x = 0; x < frame.width; ++x) {
      grey[x] = view.grey(frame.y + in, frame.x + x) - kMiddleGrey;
    }
    sums.Push(grey, grey);
    const int out = y - radius;
    if (out < 0) {
      continue;
    }
    sums.Sum();
    for (int x = 0; x < frame.width; ++x) {
      const size_t i = size_t(out) * frame.width + x;
      const float mean = sums.Values()[x] * sums.InverseCount();
      const float variance =
          sums.Squares()[x] * sums.InverseCount() - mean * mean;
      reference.mean[i] = mean;
      reference.inverse_deviation[i] =
          1 / std::sqrt(std::max(variance, 0.0f) + reference.plain_variance);
    }
  }
  return reference;
}

// Correlation of every ray's window with one neighbour at one plane.
void CorrelatePlane(const Reference& reference,
                    const PlaneWarp& warp,
                    WindowSums* sums,
                    std::vector<float>* warped,
                    std::vector<float>* scores) {
  const int radius = sums->Radius();
  const cv::Rect& frame = reference.frame;
  const float plain_variance = reference.plain_variance;
  sums->Clear();
  for (int y = 0; y < frame.height + radius; ++y) {
    const int in = std::min(y, frame.height - 1);
    const RowRange range = reference.ranges[in];
    std::fill(warped->begin(), warped->end(), 0.0f);
    warp.Row(frame.y + in,
             frame.x + range.begin,
             frame.x + range.end,
             warped->data() + range.begin);
    sums->Push(warped->data(),
               reference.grey.data() + size_t(in) * frame.width);
    const int out = y - radius;
    if (out < 0 || reference.ranges[out].begin == reference.ranges[out].end) {
      continue;
    }
    sums->Sum();
    const float inverse_count = sums->InverseCount();
    const float* values = sums->Values();
    const float* squares = sums->Squares();
    const float* products = sums->Products();
    const size_t offset = size_t(out) * frame.width;
    const float* mean = reference.mean.data() + offset;
    const float* inverse_deviation =
        reference.inverse_deviation.data() + offset;
    float* row = scores->data() + offset;
    for (int x = 0; x < frame.width; ++x) {
      const float own_mean = values[x] * inverse_count;
      const float variance = squares[x] * inverse_count - own_mean * own_mean;
      const float covariance = products[x] * inverse_count - own_mean * mean[x];
      row[x] = covariance * inverse_deviation[x] /
               std::sqrt(std::max(variance, 0.0f) + plain_variance);
    }
  }
}

// Mean of the best half of the neighbours' scores, ray by ray: with up to half
// of the neighbours occluded the rest still agrees. Sorts the scores, so that
// the first are the best.
void MeanOfBestHalf(std::vector<std::vector<float>>* scores, float* out) {
  const size_t keep = (scores->size() + 1) / 2;
  const size_t num_rays = (*scores)[0].size();
  for (size_t rank = 0; rank < keep; ++rank) {
    float* best = (*scores)[rank].data();
    for (size_t i = rank + 1; i < scores->size(); ++i) {
      float* other = (*scores)[i].data();
      for (size_t ray = 0; ray < num_rays; ++ray) {
        const float high = std::max(best[ray], other[ray]);
        other[ray] = std::min(best[ray], other[ray]);
        best[ray] = high;
      }
    }
    const float share = 1 / float(keep);
    for (size_t ray = 0; ray < num_rays; ++ray) {
      out[ray] = (rank == 0 ? 0 : out[ray]) + best[ray] * share;
    }
  }
}

}  // namespace

ScoreVolume ScorePlanes(const std::vector<SweepView>& views,
                        int reference_index,
                        const std::vector<int>& neighbors,
                        float plane_spacing,
                        const DepthSweepOptions& options,
                        bool one_is_enough) {
  const SweepView& view = views[reference_index];
  double near, far;
  cv::minMaxLoc(view.near_depth, &near, nullptr);
  cv::minMaxLoc(view.far_depth, nullptr, &far);
  ScoreVolume volume;
  if (!(far > near)) {
    return volume;  // the view does not see the hull
  }
  const Reference reference = PrepareReference(view, options);
  volume.spacing = plane_spacing;
  volume.first_depth = float(near);
  volume.num_planes = int((far - near) / plane_spacing) + 1;
  volume.frame = reference.frame;
  volume.num_rays = reference.grey.size();
  volume.scores.resize(volume.num_rays * volume.num_planes);
  WindowSums sums(volume.frame.width, DepthSweepOptions::kWindowRadius);
  std::vector<float> warped(volume.frame.width);
  std::vector<std::vector<float>> scores(
      neighbors.size(), std::vector<float>(volume.num_rays, -1.0f));
  for (int plane = 0; plane < volume.num_planes; ++plane) {
    const float depth = volume.first_depth + float(plane) * plane_spacing;
    for (size_t i = 0; i < neighbors.size(); ++i) {
      CorrelatePlane(reference,
                     PlaneWarp(view, views[neighbors[i]], depth),
                     &sums,
                     &warped,
                     &scores[i]);
    }
    float* out = volume.scores.data() + size_t(plane) * volume.num_rays;
    MeanOfBestHalf(&scores, out);
    for (size_t ray = 0; one_is_enough && ray < volume.num_rays; ++ray) {
      out[ray] = std::max(out[ray], scores[0][ray] - kBestAlone);
    }
    for (int y = 0; y < volume.frame.height; ++y) {
      const float* near_depth =
          view.near_depth[volume.frame.y + y] + volume.frame.x;
      const float* far_depth =
          view.far_depth[volume.frame.y + y] + volume.frame.x;
      for (int x = 0; x < volume.frame.width; ++x, ++out) {
        if (depth < near_depth[x] || depth > far_depth[x]) {
          *out = -1;
        }
      }
    }
  }
  return volume;
}

}  // namespace octacut
