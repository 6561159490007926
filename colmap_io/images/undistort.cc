#include "colmap_io/images/undistort.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "colmap_io/images/bilinear_sampler.h"
#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/camera_projector.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kRowsPerChunk = 16;
// Reductions up to this factor are left to bilinear interpolation alone.
constexpr double kNoFilter = 1.25;
constexpr double kLeftToResampling = 1.5;

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
void Store(const float* sum, float scale, uint8_t* pixel) {
  constexpr float kHalf = 0.5f;  // to round; std::lround is slow
  for (int c = 0; c < kChannels; ++c) {
    pixel[c] = uint8_t(sum[c] * scale + kHalf);
  }
}

// One sample at the centre of each target pixel.
template <int kChannels>
void SampleRows(const BilinearSampler<kChannels>& sampler,
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
        Store<kChannels>(sum, 1, pixels + size_t(x) * kChannels);
      }
    }
  }
}

// Positions of n x n samples in the quadrilateral of one target pixel.
struct Quad {
  float x[4],
      y[4];  // corners: above left, above right, below left, below right

  // Calls body(x, y) until it returns false; true when it never did.
  template <typename Body>
  bool ForEachSample(int n, const Body& body) const {
    const float step = 1.0f / float(n);
    for (int j = 0; j < n; ++j) {
      const float b = (float(j) + 0.5f) * step;
      const float left_x = x[0] + b * (x[2] - x[0]);
      const float left_y = y[0] + b * (y[2] - y[0]);
      const float across_x = x[1] + b * (x[3] - x[1]) - left_x;
      const float across_y = y[1] + b * (y[3] - y[1]) - left_y;
      for (int i = 0; i < n; ++i) {
        const float a = (float(i) + 0.5f) * step;
        if (!body(left_x + a * across_x, left_y + a * across_y)) {
          return false;
        }
      }
    }
    return true;
  }
};

// The mean of n x n samples in each target pixel. Only the pixels' corners go
// through the camera model; in a pixel it is as good as bilinear.
template <int kChannels>
void AverageRows(const BilinearSampler<kChannels>& sampler,
                 const CameraProjector& projector,
                 const PinholeCamera& target,
                 int n,
                 const cv::Range& rows,
                 cv::Mat* result) {
  const size_t begin = size_t(rows.start);
  const size_t end = size_t(rows.end);
  RowMap above(target.width + 1);
  RowMap below(target.width + 1);
  below.Fill(projector, target, 0, double(begin));
  for (size_t row = begin; row < end; ++row) {
    std::swap(above, below);
    below.Fill(projector, target, 0, double(row + 1));
    uint8_t* pixels = result->ptr<uint8_t>(int(row));
    for (int x = 0; x < target.width; ++x) {
      const Quad quad = {
          {above.x[x], above.x[x + 1], below.x[x], below.x[x + 1]},
          {above.y[x], above.y[x + 1], below.y[x], below.y[x + 1]}};
      const auto [x0, x1] =
          std::minmax({quad.x[0], quad.x[1], quad.x[2], quad.x[3]});
      const auto [y0, y1] =
          std::minmax({quad.y[0], quad.y[1], quad.y[2], quad.y[3]});
      float sum[kChannels] = {};
      bool covered = true;
      if (sampler.IsInside(x0, y0, x1, y1)) {
        quad.ForEachSample(n, [&](float u, float v) {
          sampler.AddInside(u, v, sum);
          return true;
        });
      } else {
        covered = quad.ForEachSample(n, [&](float u, float v) {
          const bool there = sampler.Covers(u, v);
          if (there) {
            sampler.Add(u, v, sum);
          }
          return there;
        });
      }
      if (covered) {
        Store<kChannels>(
            sum, 1.0f / float(n * n), pixels + size_t(x) * kChannels);
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
  const BilinearSampler<kChannels> sampler(source);
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
                  AverageRows(sampler,
                              projector,
                              target,
                              samples,
                              cv::Range(int(begin), int(end)),
                              result);
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
  // the rest while resampling.
  const int k =
      int(Reduction(projector.Intrinsics(), target) / kLeftToResampling);
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

cv::Mat FindUncovered(const cv::Mat& source,
                      const SparseCamera& camera,
                      const PinholeCamera& target,
                      const cv::Mat& undistorted,
                      const Context& context) {
  if (CopiedWindow(camera, CameraProjector(camera).Intrinsics(), target)) {
    return {};
  }
  // What another value fills.
  cv::Mat uncovered =
      undistorted != Undistort(source, camera, target, 0, context);
  return cv::countNonZero(uncovered) > 0 ? uncovered : cv::Mat();
}

}  // namespace octacut
