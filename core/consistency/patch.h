// A patch of object-space samples seen by several views.
#pragma once

#include <array>

#include "core/views/view_set.h"
#include "core/visibility/visibility.h"

namespace octacut {

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

  // Samples the patch around `center` with the given normal (unit
  // coordinates); samples are `spacing` apart. Views in which more than a
  // third of the samples is background are left out.
  void Sample(const ViewSet& views,
              const Visibility::Selection& selection,
              const Eigen::Vector3f& center,
              const Eigen::Vector3f& normal,
              float spacing,
              int radius);

  // Per view: subtracts the mean colour, weights chroma (see WeightChroma), and
  // divides by the norm over samples and channels, regularised by the noise
  // (grey levels), so the squared norm that is left is the view's reliability
  // in 0 .. 1.
  void Normalize(float pixel_noise, float chroma_weight);

  int NumViews() const { return num_views_; }
  int NumSamples() const { return num_samples_; }
  const Colors& View(int i) const { return views_[i]; }

 private:
  // (2 radius + 1)^2 points center + i * step_u + j * step_v, `spacing` apart.
  struct Lattice {
    Eigen::Vector3f center;
    Eigen::Vector3f step_u;
    Eigen::Vector3f step_v;
    float spacing;
    int radius;
  };

  bool SampleView(const PreparedView& view,
                  const Lattice& lattice,
                  Colors* colors) const;

  int num_views_ = 0;
  int num_samples_ = 0;
  std::array<Colors, Visibility::kMaxViews> views_;
};

}  // namespace octacut
