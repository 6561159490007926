#include "core/evidence/window_sums.h"

#include <algorithm>

namespace octacut {
namespace {

constexpr int kNumKinds = 3;  // values, squares, products

}  // namespace

WindowSums::WindowSums(int width, int radius)
    : width_(width),
      radius_(radius),
      padded_(size_t(width) + 2 * radius, 0.0f),
      ring_(size_t(kNumKinds) * width * (2 * radius + 1), 0.0f),
      sums_(size_t(kNumKinds) * width, 0.0f) {}

void WindowSums::Clear() {
  std::fill(ring_.begin(), ring_.end(), 0.0f);
  next_ = 0;
}

void WindowSums::Push(const float* values, const float* others) {
  float* slot = ring_.data() + size_t(kNumKinds) * width_ * next_;
  next_ = (next_ + 1) % (2 * radius_ + 1);
  float* row = padded_.data() + radius_;
  for (int kind = 0; kind < kNumKinds; ++kind) {
    for (int x = 0; x < width_; ++x) {
      row[x] = values[x] * (kind == 0   ? 1.0f
                            : kind == 1 ? values[x]
                                        : others[x]);
    }
    float* out = slot + size_t(kind) * width_;
    std::copy(row - radius_, row - radius_ + width_, out);
    for (int shift = 1 - radius_; shift <= radius_; ++shift) {
      for (int x = 0; x < width_; ++x) {
        out[x] += row[x + shift];
      }
    }
  }
}

void WindowSums::Sum() {
  const size_t size = size_t(kNumKinds) * width_;
  std::copy(ring_.begin(), ring_.begin() + std::ptrdiff_t(size), sums_.begin());
  for (int slot = 1; slot <= 2 * radius_; ++slot) {
    const float* row = ring_.data() + size * slot;
    for (size_t i = 0; i < size; ++i) {
      sums_[i] += row[i];
    }
  }
}

}  // namespace octacut
