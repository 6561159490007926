// Where on a line across it the outline of an object lies, to a fraction of a
// pixel.
//
// Towards its outline, a smooth surface turns away from the camera, and what
// depends on its angle changes with the square root of the distance from the
// outline: shading, and the share of the light that gloss mirrors. At the
// outline itself gloss mirrors what is behind the object, so that there may be
// no step at all. The steepest point of such a line lies inside the object; the
// outline is where the change begins (docs/experiments/mask_borders.md).
//
// A blurred step and a square root look nearly the same on a single line, so
// the blur has to be known: it is the same for all lines of a photograph.
#pragma once

#include <array>
#include <Eigen/Core>
#include <optional>
#include <span>

namespace octacut {

// Pixels between the samples of a line.
inline constexpr float kEdgeStep = 0.25f;

// Standard deviations of what lens, pixels and interpolation blur: pixels.
inline constexpr std::array<double, 10> kOutlineBlurs = {
    0.45, 0.52, 0.6, 0.7, 0.8, 0.92, 1.04, 1.15, 1.27, 1.4};

// Samples on each side of an outline that decide where it is, and how far from
// where it is looked for it may be.
inline constexpr int kOutlineWindow = int(2.5f / kEdgeStep);
inline constexpr int kOutlineSearch = int(1.25f / kEdgeStep);

struct FittedOutline {
  // In samples. None where the best position is at the end of the search.
  std::optional<float> position;
  // The share of the variance around the position that the fit leaves.
  float residual_share = 1;
};

class OutlineFit {
 public:
  // `blur` in pixels.
  explicit OutlineFit(double blur);

  double Blur() const { return blur_; }

  // `samples` of linear light, kEdgeStep pixels apart, from outside to inside.
  // The outline is where a step and a square root, both blurred, fit the
  // samples around best, at most a pixel and a quarter from `near`, or, if it
  // is found nowhere there and `is_wide`, as much farther outside. None where
  // that range and the window do not fit into the line.
  std::optional<FittedOutline> Find(std::span<const Eigen::Vector3f> samples,
                                    int near,
                                    bool is_wide) const;

 private:
  static constexpr int kSamples = 2 * kOutlineWindow + 1;

  double blur_;
  // Orthonormal columns that span the constant, the step and the square root.
  Eigen::Matrix<float, kSamples, 3> basis_;
};

}  // namespace octacut
