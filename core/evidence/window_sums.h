// Sums over square windows of an image that arrives row by row. For
// core/evidence alone.
#pragma once

#include <cstddef>
#include <vector>

namespace octacut {

// Sums over windows of two images at once: of the first one's values and
// squares, and of the products of both. What is beyond the left and right
// border counts as 0; windows hold fewer samples near the first row.
class WindowSums {
 public:
  WindowSums(int width, int radius);

  int Radius() const { return radius_; }
  float InverseCount() const {
    return 1.0f / float((2 * radius_ + 1) * (2 * radius_ + 1));
  }
  void Clear();
  // Adds the next row of both images; the oldest of 2 radius + 1 rows drops
  // out.
  void Push(const float* values, const float* others);
  // Sums over the windows around the row pushed `radius` rows ago.
  void Sum();
  const float* Values() const { return sums_.data(); }
  const float* Squares() const { return sums_.data() + width_; }
  const float* Products() const { return sums_.data() + 2 * size_t(width_); }

 private:
  int width_;
  int radius_;
  int next_ = 0;               // slot of the ring that is written next
  std::vector<float> padded_;  // one row of each kind with a border of zeros
  std::vector<float> ring_;    // horizontal sums of the last rows
  std::vector<float> sums_;
};

}  // namespace octacut
