#include "core/evidence/score_volume.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/evidence/window_sums.h"

namespace octacut {
namespace {

// Grey-level variance below which a window counts as plain.
constexpr float kPlainVariance = 4;
// Grey values are taken from their middle: small numbers keep the digits that
// a variance needs.
constexpr float kMiddleGrey = 128;

// Samples [begin, end) of a row whose rays meet the hull.
struct RowRange {
  int begin = 0;
  int end = 0;
};

std::vector<RowRange> HullRanges(const SweepView& view) {
  std::vector<RowRange> ranges(view.grey.rows);
  for (int y = 0; y < view.grey.rows; ++y) {
    const float* far = view.far_depth[y];
    int begin = view.grey.cols;
    int end = 0;
    for (int x = 0; x < view.grey.cols; ++x) {
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
                           reference.projection->linear.inverse());
    epipole_ = neighbor.projection->Homogeneous(reference.projection->center);
  }

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
      out[x] = upper + (lower - upper) * fy - kMiddleGrey;
    }
  }

 private:
  const SweepView& neighbor_;
  float step_;
  Eigen::Matrix3f homography_;
  Eigen::Vector3f epipole_;
};

// The reference's grey values from the middle, with their window sums.
struct Reference {
  int rows = 0;
  int cols = 0;
  std::vector<float> grey;
  std::vector<float> mean;
  std::vector<float> inverse_deviation;
  std::vector<RowRange> ranges;
};

Reference PrepareReference(const SweepView& view, int radius) {
  Reference reference;
  reference.rows = view.grey.rows;
  reference.cols = view.grey.cols;
  const size_t size = size_t(reference.rows) * reference.cols;
  reference.grey.resize(size);
  reference.mean.resize(size);
  reference.inverse_deviation.resize(size);
  reference.ranges = HullRanges(view);
  WindowSums sums(reference.cols, radius);
  for (int y = 0; y < reference.rows + radius; ++y) {
    const int in = std::min(y, reference.rows - 1);
    float* grey = reference.grey.data() + size_t(in) * reference.cols;
    for (int x = 0; x < reference.cols; ++x) {
      grey[x] = view.grey(in, x) - kMiddleGrey;
    }
    sums.Push(grey, grey);
    const int out = y - radius;
    if (out < 0) {
      continue;
    }
    sums.Sum();
    for (int x = 0; x < reference.cols; ++x) {
      const size_t i = size_t(out) * reference.cols + x;
      const float mean = sums.Values()[x] * sums.InverseCount();
      const float variance =
          sums.Squares()[x] * sums.InverseCount() - mean * mean;
      reference.mean[i] = mean;
      reference.inverse_deviation[i] =
          1 / std::sqrt(std::max(variance, 0.0f) + kPlainVariance);
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
  sums->Clear();
  for (int y = 0; y < reference.rows + radius; ++y) {
    const int in = std::min(y, reference.rows - 1);
    const RowRange range = reference.ranges[in];
    std::fill(warped->begin(), warped->end(), 0.0f);
    warp.Row(in, range.begin, range.end, warped->data());
    sums->Push(warped->data(),
               reference.grey.data() + size_t(in) * reference.cols);
    const int out = y - radius;
    if (out < 0 || reference.ranges[out].begin == reference.ranges[out].end) {
      continue;
    }
    sums->Sum();
    const float inverse_count = sums->InverseCount();
    const float* values = sums->Values();
    const float* squares = sums->Squares();
    const float* products = sums->Products();
    const size_t offset = size_t(out) * reference.cols;
    const float* mean = reference.mean.data() + offset;
    const float* inverse_deviation =
        reference.inverse_deviation.data() + offset;
    float* row = scores->data() + offset;
    for (int x = 0; x < reference.cols; ++x) {
      const float own_mean = values[x] * inverse_count;
      const float variance = squares[x] * inverse_count - own_mean * own_mean;
      const float covariance = products[x] * inverse_count - own_mean * mean[x];
      row[x] = covariance * inverse_deviation[x] /
               std::sqrt(std::max(variance, 0.0f) + kPlainVariance);
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
                        int window_radius,
                        bool one_is_enough) {
  const SweepView& view = views[reference_index];
  double near, far;
  cv::minMaxLoc(view.near_depth, &near, nullptr);
  cv::minMaxLoc(view.far_depth, nullptr, &far);
  ScoreVolume volume;
  if (!(far > near)) {
    return volume;  // the view does not see the hull
  }
  const Reference reference = PrepareReference(view, window_radius);
  volume.spacing = plane_spacing;
  volume.first_depth = float(near);
  volume.num_planes = int((far - near) / plane_spacing) + 1;
  volume.num_rays = reference.grey.size();
  volume.scores.resize(volume.num_rays * volume.num_planes);
  WindowSums sums(reference.cols, window_radius);
  std::vector<float> warped(reference.cols);
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
    const float* near_depth = view.near_depth[0];
    const float* far_depth = view.far_depth[0];
    for (size_t ray = 0; ray < volume.num_rays; ++ray) {
      if (depth < near_depth[ray] || depth > far_depth[ray]) {
        out[ray] = -1;
      }
    }
  }
  return volume;
}

}  // namespace octacut
