// A patch of samples on a local surface, seen by several views, moved along
// its normal: how well do the views agree where?
#pragma once

#include <array>
#include <vector>

#include "core/refine/local_surface.h"
#include "core/refine/view_choice.h"
#include "core/views/view_set.h"

namespace octacut {

// By how many pixels a view's image of a patch is shifted against the mean
// image of all views, as normal equations: products * shift = right.
struct ImageShift {
  uint16_t view = 0;
  // Correlation with the mean image.
  float agreement = 0;
  // Squared norm of the difference from the mean image, where that of the
  // view's own image is 1.
  float residual = 0;
  Eigen::Matrix2f products = Eigen::Matrix2f::Zero();
  Eigen::Vector2f right = Eigen::Vector2f::Zero();
};

// How views are compared on a patch.
struct PatchOptions {
  // (2 r + 1)^2 samples in a square, which weigh less towards its border;
  // 1 .. 4. 2 and 4 are worse: docs/experiments/refinement_patches.md.
  int radius = 3;
  // Standard deviation of the images' noise, grey levels: contrast below it
  // counts as plain. 1 is worse: docs/experiments/refinement_rounds.md.
  static constexpr double kPixelNoise = 0.5;
  // Weight of differences in chroma relative to differences in brightness,
  // which highlights change most (see WeightChroma); 0 .. 8.
  double chroma_weight = 2;
  void Check() const;
};

class SurfacePatch {
 public:
  static constexpr int kMaxRadius = 4;
  static constexpr int kMaxSamples =
      (2 * kMaxRadius + 1) * (2 * kMaxRadius + 1);

  SurfacePatch(const ViewSet& views, const PatchOptions& options);

  // Puts the patch onto `surface`, with samples `spacing` apart (unit
  // coordinates). Views in which background shows in it, even in part of a
  // pixel, are left out: at the outline of the object it would draw the offset
  // inside (docs/experiments/refinement_patches.md).
  void MoveTo(const LocalSurface& surface,
              const ChosenViews& chosen,
              float spacing);
  int NumViews() const { return num_views_; }
  // The sum of the views' weights.
  float SumOfWeights() const;
  // Of the mean brightness that the views show where the patch was placed.
  float Mattness() const;

  // Agreement of the views about the patch moved by `offset` along the normal:
  // mean over pairs of views of the correlation of their colours, weighted by
  // the views' weights. At most 1.
  float Score(float offset);

  // One for each view, about the patch where it was placed.
  std::vector<ImageShift> FindShifts();

 private:
  // Homogeneous pixel coordinates of the samples at offset 0, and what a unit
  // of offset adds; their colours at offset 0.
  struct Projected {
    uint16_t view;
    const PyramidLevel* level;
    Eigen::Vector3f step;
    float weight;
    alignas(16) std::array<float, kMaxSamples> x, y, z;
    std::array<Float4, kMaxSamples> colors;
  };

  void SampleColors(const Projected& projected,
                    float offset,
                    std::array<Float4, kMaxSamples>* colors) const;
  bool ShowsOnlyObject(const Projected& projected) const;
  // Takes out the mean and part of the gradient, in which light and shade are
  // strong; weights chroma, and samples by the roots of their weights.
  void Normalize(std::array<Float4, kMaxSamples>* image) const;
  // Normalises the samples of a view into colors_; returns their squared norm.
  float SampleView(const Projected& projected, float offset);
  // Normal equations of a view whose normalised image is `image`, of squared
  // norm `square`, and differs from the mean one by `residual`.
  void AddGradients(const Projected& projected,
                    float gain,
                    const std::array<Float4, kMaxSamples>& image,
                    float square,
                    const std::array<Float4, kMaxSamples>& residual,
                    ImageShift* shift) const;

  const ViewSet& views_;
  int radius_;
  int num_samples_;
  float noise_;
  float chroma_weight_;
  std::array<float, kMaxSamples> weights_;  // sum to 1
  // Positions of the samples, in spacings from the middle, and what a sample
  // adds to the slope that is removed.
  std::array<float, kMaxSamples> columns_, rows_;
  std::array<float, kMaxSamples> slopes_u_, slopes_v_;
  std::array<float, kMaxSamples> root_weights_;
  int num_views_ = 0;
  std::array<Projected, ChosenViews::kMaxViews> projected_;
  std::array<Float4, kMaxSamples> colors_;
};

}  // namespace octacut
