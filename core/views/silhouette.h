// A view's silhouette, prepared for conservative footprint tests.
#pragma once

#include <cstdint>
#include <limits>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

#include "core/scene/scene.h"
#include "core/views/view_projection.h"

namespace octacut {

// Coverage (0 .. 255), interpolated, from which on a point counts as object.
inline constexpr float kObjectCoverage = kObjectThreshold - 0.5f;

enum class Containment : uint8_t {
  kBackground,  // holds no pixel of the object, nor does what is near
  kObject,      // holds nothing else
  kMixed,       // both, or reaches out of the frame: the view does not tell
};

class Silhouette {
 public:
  Silhouette() = default;
  // `mask` and `unknown` as View has them.
  explicit Silhouette(const cv::Mat& mask, const cv::Mat& unknown = cv::Mat());

  size_t NumObjectPixels() const { return sums_.back(); }
  // Whether the pixel at these coordinates is in the frame and not unknown.
  bool IsKnown(float u, float v) const {
    return u >= 0 && v >= 0 && u < float(width_) && v < float(height_) &&
           distances_[size_t(v) * width_ + size_t(u)] != kUnknown;
  }

  // Whether SignedDistance depends on known pixels alone at all coordinates in
  // [u0, u1] x [v0, v1]; false where in doubt.
  bool KnowsAll(float u0, float v0, float u1, float v1) const {
    return u0 >= known_.x && v0 >= known_.y && u1 <= known_.x + known_.width &&
           v1 <= known_.y + known_.height;
  }

  // Pixels with coordinates in [u0, u1] x [v0, v1]. Background only when the
  // object is farther than `margin` pixels away (in u or v).
  Containment Test(
      float u0, float v0, float u1, float v1, float margin = 0) const;

  // A cube with the given centre and half edge (unit coordinates),
  // conservatively: by the pixel rectangle around its projected corners.
  Containment TestCube(const ViewProjection& projection,
                       const Eigen::Vector3f& center,
                       float half_edge,
                       float margin = 0) const;

  // Whether TestCube would say kBackground; cheaper where it would not.
  bool IsBackgroundCube(const ViewProjection& projection,
                        const Eigen::Vector3f& center,
                        float half_edge,
                        float margin = 0) const;

  // Distance (pixels) from the border of the object, positive inside, to some
  // quarter of a pixel; bilinear. At least kFarInside where the view does not
  // tell: out of the frame and at unknown pixels.
  static constexpr float kFarInside = 1000;
  float SignedDistance(float u, float v) const;

  // Coverage (0 .. 255) at pixel coordinates, bilinear; 255 out of the frame.
  float Coverage(float u, float v) const;

 private:
  // Object pixels of those that the rectangle, within the frame, touches.
  uint32_t CountObject(
      float u0, float v0, float u1, float v1, uint32_t* num_pixels) const;

  int width_ = 0;
  int height_ = 0;
  std::vector<uint32_t> sums_;  // summed-area table, (width + 1) x (height + 1)
  cv::Mat mask_;
  cv::Rect2f known_;  // see KnowsAll
  // Signed distances of pixel centres, in units of 1 / kDistanceScale pixels,
  // or kUnknown, which is beyond them.
  static constexpr int16_t kUnknown = std::numeric_limits<int16_t>::max();
  std::vector<int16_t> distances_;
};

}  // namespace octacut
