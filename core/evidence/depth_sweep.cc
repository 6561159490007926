#include "core/evidence/depth_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/evidence/neighbor_views.h"

namespace octacut {
namespace {

// A view reduced to the scale of the sweep: grey values, and the interval of
// depths that the hull occupies along each sample's ray.
struct SweepView {
  const ViewProjection* projection;
  float scale = 1;
  cv::Mat_<float> grey;
  cv::Mat_<float> near_depth;  // infinity where the ray misses the hull
  cv::Mat_<float> far_depth;
};

SweepView ReduceView(const PreparedView& view,
                     const VoxelGrid& hull,
                     double samples_per_voxel) {
  const ViewProjection& projection = view.projection;
  const float voxel = 1.0f / float(hull.Resolution());
  const float depth = std::max(
      projection.Homogeneous(Eigen::Vector3f::Constant(0.5f)).z(), voxel);
  SweepView reduced;
  reduced.projection = &projection;
  reduced.scale = std::min(
      1.0f, float(samples_per_voxel) / projection.Footprint(voxel, depth));
  const int width = std::max(2, int(projection.width * reduced.scale));
  const int height = std::max(2, int(projection.height * reduced.scale));
  reduced.grey.create(height, width);
  const PyramidLevel& level = view.pyramid.LevelForFootprint(1 / reduced.scale);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Float4 color = level.Sample((float(x) + 0.5f) / reduced.scale,
                                        (float(y) + 0.5f) / reduced.scale);
      reduced.grey(y, x) =
          0.114f * color[0] + 0.587f * color[1] + 0.299f * color[2];
    }
  }
  reduced.near_depth.create(height, width);
  reduced.far_depth.create(height, width);
  reduced.near_depth.setTo(std::numeric_limits<float>::infinity());
  reduced.far_depth.setTo(0);
  return reduced;
}

void MarkHullDepths(const VoxelGrid& hull, SweepView* view) {
  const float voxel = 1.0f / float(hull.Resolution());
  hull.ForEach([&](VoxelGrid::Index, MortonCode code) {
    const Eigen::Vector3f h = view->projection->Homogeneous(
        VoxelCenter(DecodeMorton(code), hull.Level()));
    if (h.z() <= voxel) {
      return;
    }
    const float reach =
        0.5f * view->scale * view->projection->Footprint(voxel, h.z());
    const float x = h.x() / h.z() * view->scale;
    const float y = h.y() / h.z() * view->scale;
    const int x0 = std::max(0, int(x - reach));
    const int y0 = std::max(0, int(y - reach));
    const int x1 = std::min(view->grey.cols - 1, int(x + reach));
    const int y1 = std::min(view->grey.rows - 1, int(y + reach));
    for (int row = y0; row <= y1; ++row) {
      for (int column = x0; column <= x1; ++column) {
        float& near = view->near_depth(row, column);
        float& far = view->far_depth(row, column);
        near = std::min(near, h.z() - voxel);
        far = std::max(far, h.z() + voxel);
      }
    }
  });
}

// Box-filtered first and second moments of the reference, once a view.
struct ReferenceMoments {
  cv::Mat_<float> mean;
  cv::Mat_<float> inverse_deviation;
};

void BoxMean(const cv::Mat_<float>& in, int radius, cv::Mat_<float>* out) {
  cv::boxFilter(in,
                *out,
                CV_32F,
                cv::Size(2 * radius + 1, 2 * radius + 1),
                cv::Point(-1, -1),
                true,
                cv::BORDER_REPLICATE);
}

// Grey-level variance below which a window counts as plain.
constexpr float kPlainVariance = 4;

ReferenceMoments MomentsOf(const cv::Mat_<float>& grey, int radius) {
  ReferenceMoments moments;
  BoxMean(grey, radius, &moments.mean);
  cv::Mat_<float> mean_square;
  BoxMean(grey.mul(grey), radius, &mean_square);
  cv::Mat_<float> variance = mean_square - moments.mean.mul(moments.mean);
  cv::max(variance, 0, variance);
  cv::sqrt(variance + kPlainVariance, moments.inverse_deviation);
  cv::divide(1, moments.inverse_deviation, moments.inverse_deviation);
  return moments;
}

// The neighbour's grey values where the plane at `depth` of the reference's
// rays projects to.
void WarpPlane(const SweepView& reference,
               const SweepView& neighbor,
               float depth,
               cv::Mat_<float>* warped) {
  const Eigen::Matrix3f rays = reference.projection->linear.inverse();
  const Eigen::Matrix3f homography =
      depth * (neighbor.projection->linear * rays);
  const Eigen::Vector3f epipole =
      neighbor.projection->Homogeneous(reference.projection->center);
  const float step = 1 / reference.scale;
  const float max_x = float(neighbor.grey.cols - 1);
  const float max_y = float(neighbor.grey.rows - 1);
  for (int y = 0; y < reference.grey.rows; ++y) {
    const float v = (float(y) + 0.5f) * step;
    const float* far = reference.far_depth[y];
    float* out = (*warped)[y];
    const Eigen::Vector3f row =
        homography.col(1) * v + homography.col(2) + epipole;
    for (int x = 0; x < reference.grey.cols; ++x) {
      out[x] = 0;
      if (far[x] == 0) {
        continue;
      }
      const Eigen::Vector3f h =
          row + homography.col(0) * ((float(x) + 0.5f) * step);
      const float inverse = neighbor.scale / h.z();
      const float sx = std::clamp(h.x() * inverse - 0.5f, 0.0f, max_x - 0.001f);
      const float sy = std::clamp(h.y() * inverse - 0.5f, 0.0f, max_y - 0.001f);
      const int x0 = int(sx);
      const int y0 = int(sy);
      const float fx = sx - float(x0);
      const float fy = sy - float(y0);
      const float* top = neighbor.grey[y0] + x0;
      const float* bottom = neighbor.grey[y0 + 1] + x0;
      out[x] = (top[0] * (1 - fx) + top[1] * fx) * (1 - fy) +
               (bottom[0] * (1 - fx) + bottom[1] * fx) * fy;
    }
  }
}

// Keeps per sample the sum of the best half of the neighbours' correlations:
// with up to half of them occluded, the rest still agree.
class BestHalf {
 public:
  BestHalf(int rows, int cols, int num_neighbors)
      : keep_((num_neighbors + 1) / 2) {
    for (int i = 0; i < keep_; ++i) {
      best_.emplace_back(rows, cols);
    }
  }
  void Reset() {
    for (cv::Mat_<float>& best : best_) {
      best.setTo(-1);
    }
  }
  void Add(int y, int x, float score) {
    for (cv::Mat_<float>& best : best_) {
      float& slot = best(y, x);
      if (score > slot) {
        std::swap(score, slot);
      }
    }
  }
  float Mean(int y, int x) const {
    float sum = 0;
    for (const cv::Mat_<float>& best : best_) {
      sum += best(y, x);
    }
    return sum / float(keep_);
  }

 private:
  int keep_;
  std::vector<cv::Mat_<float>> best_;
};

// Scores of all planes of one view: scores[(y * width + x) * planes + plane].
struct ScoreVolume {
  int num_planes = 0;
  float first_depth = 0;
  float spacing = 0;
  std::vector<float> scores;
};

ScoreVolume ScorePlanes(const std::vector<SweepView>& views,
                        int reference_index,
                        const std::vector<int>& neighbors,
                        float voxel,
                        const DepthSweepOptions& options) {
  const SweepView& reference = views[reference_index];
  const int rows = reference.grey.rows;
  const int cols = reference.grey.cols;
  double near, far;
  cv::minMaxLoc(reference.near_depth, &near, nullptr);
  cv::minMaxLoc(reference.far_depth, nullptr, &far);
  ScoreVolume volume;
  volume.spacing = voxel / float(options.planes_per_voxel);
  volume.first_depth = float(near);
  if (!(far > near)) {
    return volume;  // the view does not see the hull
  }
  volume.num_planes = int((far - near) / volume.spacing) + 1;
  volume.scores.assign(size_t(rows) * cols * volume.num_planes, -1.0f);
  const ReferenceMoments moments =
      MomentsOf(reference.grey, options.window_radius);
  BestHalf best(rows, cols, int(neighbors.size()));
  cv::Mat_<float> warped(rows, cols), mean, mean_square, mean_product;
  for (int plane = 0; plane < volume.num_planes; ++plane) {
    const float depth = volume.first_depth + float(plane) * volume.spacing;
    best.Reset();
    for (const int neighbor : neighbors) {
      WarpPlane(reference, views[neighbor], depth, &warped);
      BoxMean(warped, options.window_radius, &mean);
      BoxMean(warped.mul(warped), options.window_radius, &mean_square);
      BoxMean(warped.mul(reference.grey), options.window_radius, &mean_product);
      for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < cols; ++x) {
          const float variance =
              std::max(0.0f, mean_square(y, x) - mean(y, x) * mean(y, x));
          const float covariance =
              mean_product(y, x) - mean(y, x) * moments.mean(y, x);
          best.Add(y,
                   x,
                   covariance * moments.inverse_deviation(y, x) /
                       std::sqrt(variance + kPlainVariance));
        }
      }
    }
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < cols; ++x) {
        if (depth >= reference.near_depth(y, x) &&
            depth <= reference.far_depth(y, x)) {
          volume.scores[(size_t(y) * cols + x) * volume.num_planes + plane] =
              best.Mean(y, x);
        }
      }
    }
  }
  return volume;
}

// The best plane of a ray, refined by a parabola; 0 when it does not stand
// out from every other peak.
float PickDepth(const float* scores,
                const ScoreVolume& volume,
                float min_score,
                float* score) {
  constexpr float kPeakMargin = 0.03f;
  constexpr int kPeakWidth = 3;  // planes
  const int n = volume.num_planes;
  const int best = int(std::max_element(scores, scores + n) - scores);
  *score = scores[best];
  if (*score < min_score) {
    return 0;
  }
  for (int i = 0; i < n; ++i) {
    if (std::abs(i - best) > kPeakWidth && scores[i] > *score - kPeakMargin) {
      return 0;
    }
  }
  float offset = 0;
  if (best > 0 && best + 1 < n && scores[best - 1] > -1 &&
      scores[best + 1] > -1) {
    const float curvature =
        scores[best - 1] - 2 * scores[best] + scores[best + 1];
    if (curvature < 0) {
      offset = 0.5f * (scores[best - 1] - scores[best + 1]) / curvature;
    }
  }
  return volume.first_depth +
         (float(best) + std::clamp(offset, -0.5f, 0.5f)) * volume.spacing;
}

SweptDepthMap PickDepths(const SweepView& view,
                         const ScoreVolume& volume,
                         float min_score) {
  SweptDepthMap map;
  map.width = view.grey.cols;
  map.height = view.grey.rows;
  map.scale = view.scale;
  const size_t size = size_t(map.width) * map.height;
  map.depths.assign(size, 0);
  map.scores.assign(size, 0);
  for (size_t i = 0; i < size && volume.num_planes > 0; ++i) {
    map.depths[i] = PickDepth(volume.scores.data() + i * volume.num_planes,
                              volume,
                              min_score,
                              &map.scores[i]);
  }
  return map;
}

}  // namespace

void DepthSweepOptions::Check() const {
  CheckOption(num_neighbors >= 2 && num_neighbors <= 8,
              "num_neighbors",
              num_neighbors,
              "must be in 2 .. 8");
  CheckOption(min_angle >= 0 && min_angle < max_angle && max_angle <= 90,
              "max_angle",
              max_angle,
              "must be greater than min_angle and at most 90");
  CheckOption(samples_per_voxel >= 0.5 && samples_per_voxel <= 4,
              "samples_per_voxel",
              samples_per_voxel,
              "must be in 0.5 .. 4");
  CheckOption(planes_per_voxel >= 0.5 && planes_per_voxel <= 4,
              "planes_per_voxel",
              planes_per_voxel,
              "must be in 0.5 .. 4");
  CheckOption(window_radius >= 1 && window_radius <= 8,
              "window_radius",
              window_radius,
              "must be in 1 .. 8");
  CheckOption(min_score > 0 && min_score < 1,
              "min_score",
              min_score,
              "must lie between 0 and 1");
}

std::vector<SweptDepthMap> SweepDepths(
    const ViewSet& views,
    const VoxelGrid& hull,
    const DepthSweepOptions& options,
    const Context& context,
    std::vector<std::vector<int>>* neighbors) {
  options.Check();
  Phase phase(context, "depth sweep", 2 * views.size());
  *neighbors = SelectNeighborViews(
      views, options.num_neighbors, options.min_angle, options.max_angle);
  std::vector<SweepView> reduced(views.size());
  ParallelFor(context, views.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      reduced[i] = ReduceView(views[i], hull, options.samples_per_voxel);
      MarkHullDepths(hull, &reduced[i]);
      phase.Advance();
    }
  });
  std::vector<SweptDepthMap> maps(views.size());
  const float voxel = 1.0f / float(hull.Resolution());
  ParallelFor(context, views.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      // One neighbour alone cannot tell an occlusion from a mismatch.
      const ScoreVolume volume =
          (*neighbors)[i].size() >= 2
              ? ScorePlanes(reduced, int(i), (*neighbors)[i], voxel, options)
              : ScoreVolume();
      maps[i] = PickDepths(reduced[i], volume, float(options.min_score));
      phase.Advance();
    }
  });
  return maps;
}

}  // namespace octacut
