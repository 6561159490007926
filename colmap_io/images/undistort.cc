#include "colmap_io/images/undistort.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/camera_projector.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kRowsPerChunk = 16;
// Reductions up to this factor are left to bilinear interpolation alone.
constexpr double kNoFilter = 1.25;

// Source pixel of every sample position along rows of target pixels.
struct RowMap {
  explicit RowMap(int count) : x(count), y(count) {}
  std::vector<float> x, y;

  // Target coordinates (first + i, row).
  void Fill(const CameraProjector& projector,
            const PinholeCamera& target,
            double first,
            double row) {
    projector.ImgFromCamRow(target.Unproject({first, row}),
                            {1 / target.fx, 0, 0},
                            x.size(),
                            x.data(),
                            y.data());
  }
};

template <int kChannels>
class Sampler {
 public:
  explicit Sampler(const cv::Mat& source)
      : source_(source),
        width_(float(source.cols)),
        height_(float(source.rows)) {}

  bool Covers(float x, float y) const {
    return x >= 0 && y >= 0 && x <= width_ && y <= height_;
  }

  // Adds the bilinear sample at pixel coordinates; Covers() must hold.
  void Add(float x, float y, float* sum) const {
    const float u = std::clamp(x - 0.5f, 0.0f, width_ - 1);
    const float v = std::clamp(y - 0.5f, 0.0f, height_ - 1);
    const int x0 = int(u);
    const int y0 = int(v);
    const int right = x0 + 1 < source_.cols ? kChannels : 0;
    const uint8_t* top = source_.ptr<uint8_t>(y0) + x0 * kChannels;
    const uint8_t* bottom =
        source_.ptr<uint8_t>(std::min(y0 + 1, source_.rows - 1)) +
        x0 * kChannels;
    const float a = u - float(x0);
    const float b = v - float(y0);
    for (int c = 0; c < kChannels; ++c) {
      const float above = top[c] + a * (float(top[c + right]) - top[c]);
      const float below =
          bottom[c] + a * (float(bottom[c + right]) - bottom[c]);
      sum[c] += above + b * (below - above);
    }
  }

 private:
  const cv::Mat& source_;
  float width_, height_;
};

template <int kChannels>
void Store(const float* sum, float scale, uint8_t* pixel) {
  for (int c = 0; c < kChannels; ++c) {
    pixel[c] = uint8_t(sum[c] * scale + 0.5f);
  }
}

// One sample at the centre of each target pixel.
template <int kChannels>
void SampleRows(const Sampler<kChannels>& sampler,
                const CameraProjector& projector,
                const PinholeCamera& target,
                size_t begin,
                size_t end,
                cv::Mat* result) {
  RowMap map(target.width);
  for (size_t row = begin; row < end; ++row) {
    map.Fill(projector, target, 0.5, double(row) + 0.5);
    uint8_t* pixels = result->ptr<uint8_t>(int(row));
    for (int x = 0; x < target.width; ++x) {
      if (sampler.Covers(map.x[x], map.y[x])) {
        float sum[kChannels] = {};
        sampler.Add(map.x[x], map.y[x], sum);
        Store<kChannels>(sum, 1, pixels + x * kChannels);
      }
    }
  }
}

// The mean of n x n samples in each target pixel. Only the pixels' corners go
// through the camera model; in a pixel it is as good as bilinear.
template <int kChannels>
void AverageRows(const Sampler<kChannels>& sampler,
                 const CameraProjector& projector,
                 const PinholeCamera& target,
                 int n,
                 size_t begin,
                 size_t end,
                 cv::Mat* result) {
  RowMap above(target.width + 1);
  RowMap below(target.width + 1);
  below.Fill(projector, target, 0, double(begin));
  const float step = 1.0f / float(n);
  for (size_t row = begin; row < end; ++row) {
    std::swap(above, below);
    below.Fill(projector, target, 0, double(row + 1));
    uint8_t* pixels = result->ptr<uint8_t>(int(row));
    for (int x = 0; x < target.width; ++x) {
      float sum[kChannels] = {};
      bool covered = true;
      for (int j = 0; j < n && covered; ++j) {
        const float b = (float(j) + 0.5f) * step;
        const float left_x = above.x[x] + b * (below.x[x] - above.x[x]);
        const float left_y = above.y[x] + b * (below.y[x] - above.y[x]);
        const float right_x =
            above.x[x + 1] + b * (below.x[x + 1] - above.x[x + 1]);
        const float right_y =
            above.y[x + 1] + b * (below.y[x + 1] - above.y[x + 1]);
        for (int i = 0; i < n && covered; ++i) {
          const float a = (float(i) + 0.5f) * step;
          const float u = left_x + a * (right_x - left_x);
          const float v = left_y + a * (right_y - left_y);
          covered = sampler.Covers(u, v);
          if (covered) {
            sampler.Add(u, v, sum);
          }
        }
      }
      if (covered) {
        Store<kChannels>(sum, step * step, pixels + x * kChannels);
      }
    }
  }
}

double Reduction(const CameraIntrinsics& source, const PinholeCamera& target) {
  return std::max(source.fx / target.fx, source.fy / target.fy);
}

template <int kChannels>
void Resample(const cv::Mat& source,
              const CameraProjector& projector,
              const PinholeCamera& target,
              const Context& context,
              cv::Mat* result) {
  const Sampler<kChannels> sampler(source);
  const double reduction = Reduction(projector.Intrinsics(), target);
  const int samples =
      reduction <= kNoFilter ? 1 : int(std::ceil(reduction - 1e-6));
  ParallelFor(context,
              size_t(target.height),
              kRowsPerChunk,
              [&](size_t begin, size_t end) {
                if (samples == 1) {
                  SampleRows(sampler, projector, target, begin, end, result);
                } else {
                  AverageRows(
                      sampler, projector, target, samples, begin, end, result);
                }
              });
}

// The camera of the same picture with blocks of k x k pixels for pixels;
// blocks that are not whole are left off.
SparseCamera CameraOfBlocks(SparseCamera camera, int k) {
  const int num_lengths =  // focal lengths and principal point come first
      FindCameraModel(camera.model_id)->num_focal_lengths + 2;
  for (int i = 0; i < num_lengths; ++i) {
    camera.params[i] /= k;
  }
  camera.width /= uint64_t(k);
  camera.height /= uint64_t(k);
  return camera;
}

// The means of the blocks.
cv::Mat MeanOfBlocks(const cv::Mat& source, const cv::Size& size, int k) {
  cv::Mat blocks;
  cv::resize(source(cv::Rect(0, 0, size.width * k, size.height * k)),
             blocks,
             size,
             0,
             0,
             cv::INTER_AREA);
  return blocks;
}

// The part of the source that the target copies pixel by pixel, if it does.
std::optional<cv::Rect> CopiedWindow(const SparseCamera& camera,
                                     const CameraIntrinsics& intrinsics,
                                     const PinholeCamera& target) {
  const double x = intrinsics.cx - target.cx;
  const double y = intrinsics.cy - target.cy;
  const bool fits = x >= 0 && y >= 0 &&
                    x + target.width <= double(camera.width) &&
                    y + target.height <= double(camera.height);
  if (!IsPinhole(camera) || target.fx != intrinsics.fx ||
      target.fy != intrinsics.fy || !fits ||
      std::abs(x - std::round(x)) > 1e-9 ||
      std::abs(y - std::round(y)) > 1e-9) {
    return {};
  }
  return cv::Rect(
      int(std::lround(x)), int(std::lround(y)), target.width, target.height);
}

}  // namespace

cv::Mat Undistort(const cv::Mat& source,
                  const SparseCamera& camera,
                  const PinholeCamera& target,
                  uint8_t uncovered,
                  const Context& context) {
  if (uint64_t(source.cols) != camera.width ||
      uint64_t(source.rows) != camera.height) {
    throw InvariantError(
        fmt::format("Undistort: a source of {}x{} pixels for a camera of {}x{}",
                    source.cols,
                    source.rows,
                    camera.width,
                    camera.height));
  }
  const CameraProjector projector(camera);
  if (const auto window =
          CopiedWindow(camera, projector.Intrinsics(), target)) {
    return source(*window).clone();
  }
  // Strong reductions: most of it by means of whole blocks, which is fast, and
  // the rest, at least a factor of two, while resampling.
  const int k = int(Reduction(projector.Intrinsics(), target) / 2);
  if (k >= 2 && source.cols >= k && source.rows >= k) {
    const SparseCamera camera_of_blocks = CameraOfBlocks(camera, k);
    const cv::Size size(int(camera_of_blocks.width),
                        int(camera_of_blocks.height));
    return Undistort(MeanOfBlocks(source, size, k),
                     camera_of_blocks,
                     target,
                     uncovered,
                     context);
  }
  cv::Mat result(
      target.height, target.width, source.type(), cv::Scalar::all(uncovered));
  if (source.channels() == 1) {
    Resample<1>(source, projector, target, context, &result);
  } else {
    Resample<3>(source, projector, target, context, &result);
  }
  return result;
}

}  // namespace octacut
