// A patch of object-space samples seen by several views.
#pragma once

#include <array>

#include "core/views/view_set.h"
#include "core/visibility/visibility.h"

namespace octacut {

// Where samples are taken, unit coordinates: (2 radius + 1)^2 points, `spacing`
// apart, on the paraboloid that touches the tangent plane at `center`. On the
// plane itself they would fit a curved surface best somewhat below it: mean
// photo-consistency would be lowest inside of what is convex, and outside of
// what is hollow.
struct PatchSurface {
  Eigen::Vector3f center;
  Eigen::Vector3f normal;
  float curvature;  // mean, 1/unit; positive where convex
  float spacing;
  int radius;
};

class Patch {
 public:
  static constexpr int kMaxRadius = 4;
  static constexpr int kMaxSamples =
      (2 * kMaxRadius + 1) * (2 * kMaxRadius + 1);

  // Colours of one view: blue, green, red (and 0) a sample.
  struct Colors {
    std::array<Float4, kMaxSamples> samples;
    float weight = 0;       // of the view
    float reliability = 0;  // contrast / (contrast + noise), after Normalize
  };

  // Views in which a sample is background are left out
  // (docs/experiments/photo_consistency.md).
  void Sample(const ViewSet& views,
              const Visibility::Selection& selection,
              const PatchSurface& surface);

  // Per view: subtracts the mean colour, weights chroma (see WeightChroma), and
  // divides by the norm over samples and channels, regularised by the noise
  // (grey levels), so the squared norm that is left is the view's reliability
  // in 0 .. 1.
  void Normalize(float pixel_noise, float chroma_weight);

  int NumViews() const { return num_views_; }
  int NumSamples() const { return num_samples_; }
  const Colors& View(int i) const { return views_[i]; }

 private:
  // With steps of one sample along the surface, and by which it falls off one
  // sample away from the centre.
  struct Steps {
    Eigen::Vector3f u;
    Eigen::Vector3f v;
    Eigen::Vector3f fall;
  };

  // Returns false where background shows.
  bool SampleView(const PreparedView& view,
                  const PatchSurface& surface,
                  const Steps& steps,
                  Colors* colors) const;

  int num_views_ = 0;
  int num_samples_ = 0;
  std::array<Colors, Visibility::kMaxViews> views_;
};

}  // namespace octacut
