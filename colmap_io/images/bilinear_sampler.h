// Bilinear samples of pictures of 8 bits per channel.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace octacut {

// Pixel coordinates as the camera models have them: the centre of the first
// pixel is (0.5, 0.5). The picture must outlive the sampler.
template <int kChannels>
class BilinearSampler {
 public:
  explicit BilinearSampler(const cv::Mat& source)
      : source_(source),
        step_(source.step),
        width_(float(source.cols)),
        height_(float(source.rows)) {}

  bool Covers(float x, float y) const {
    return x >= 0 && y >= 0 && x <= width_ && y <= height_;
  }

  // All of the rectangle is away from the border by a pixel or more.
  bool IsInside(float x0, float y0, float x1, float y1) const {
    return x0 >= 1 && y0 >= 1 && x1 <= width_ - 1 && y1 <= height_ - 1;
  }

  // Adds the bilinear sample at pixel coordinates; Covers() must hold.
  void Add(float x, float y, float* sum) const {
    const float u = std::clamp(x - 0.5f, 0.0f, width_ - 1);
    const float v = std::clamp(y - 0.5f, 0.0f, height_ - 1);
    const int x0 = int(u);
    const int y0 = int(v);
    const int right = x0 + 1 < source_.cols ? kChannels : 0;
    const size_t down = y0 + 1 < source_.rows ? step_ : 0;
    Blend(TopLeft(x0, y0), right, down, u - float(x0), v - float(y0), sum);
  }

  // The same where IsInside() holds.
  void AddInside(float x, float y, float* sum) const {
    const float u = x - 0.5f;
    const float v = y - 0.5f;
    const int x0 = int(u);
    const int y0 = int(v);
    Blend(TopLeft(x0, y0), kChannels, step_, u - float(x0), v - float(y0), sum);
  }

 private:
  const uint8_t* TopLeft(int x, int y) const {
    return source_.data + size_t(y) * step_ + size_t(x) * kChannels;
  }
  static void Blend(const uint8_t* top,
                    int right,
                    size_t down,
                    float a,
                    float b,
                    float* sum) {
    const uint8_t* bottom = top + down;
    for (int c = 0; c < kChannels; ++c) {
      const float above = top[c] + a * float(top[c + right] - top[c]);
      const float below = bottom[c] + a * float(bottom[c + right] - bottom[c]);
      sum[c] += above + b * (below - above);
    }
  }

  const cv::Mat& source_;
  size_t step_;
  float width_, height_;
};

}  // namespace octacut
