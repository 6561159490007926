// Whether a mesh fills the silhouettes that it was made from: the share of
// their pixels that it covers, exceeds, and misses.
//
// What the masks say is only known up to a border of some pixels. Pixels of the
// object that the mesh leaves uncovered count as missed where they lie farther
// inside than that, and as unsure within it.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/context.h"
#include "core/raycast/ray_scene.h"
#include "core/scene/scene.h"
#include "core/views/view_set.h"

namespace octacut {

// Pixels of a view by which the border of its mask may lie elsewhere.
struct BorderUncertainty {
  double inward = 0;
  double outward = 0;
};

// A pixel more than what is known of the mask: half a pixel, since a mask says
// of each pixel only whether its larger part is object, and half a pixel, since
// a ray through the middle of a pixel says no more of the mesh. Inward that is
// `border_shift`, the pixels by which refinement has found the masks to be too
// large (negative: too small); outward the pixels by which masks may be too
// small by `mask_tolerance`, or by that shift.
BorderUncertainty UncertaintyOfBorders(double border_shift,
                                       double mask_tolerance);

// That of the mask as it was given, and as it was repaired.
struct MaskUncertainty {
  BorderUncertainty given;
  BorderUncertainty repaired;
};

// Numbers of pixels of a view, or of several.
struct PixelCounts {
  size_t object = 0;   // of the mask
  size_t border = 0;   // of those, within the border's uncertainty
  size_t covered = 0;  // of the object, by the mesh
  size_t unsure = 0;   // of the border, uncovered
  size_t missed = 0;   // of the object, neither covered nor unsure
  // Missed pixels, roughly, on whose rays other masks leave nothing, so that no
  // object fills all masks.
  size_t contradicted = 0;
  size_t exceeded = 0;         // background that the mesh covers
  size_t surely_exceeded = 0;  // of those, outside the border's uncertainty

  size_t Sure() const { return object - border; }
  PixelCounts& operator+=(const PixelCounts& other);
};

struct MaskCheck {
  std::vector<PixelCounts> views;  // one per view
  PixelCounts total;
  // For each view, how many of the missed pixels of others its mask denies,
  // alone or with one other.
  std::vector<size_t> denied_of_others;
};

// The counts of one view, without its unknown pixels. `mesh` is that of
// RenderHits; `missed` (CV_8UC1) becomes 255 where pixels are missed.
PixelCounts CountPixels(const Silhouette& silhouette,
                        const cv::Mat& mesh,
                        const BorderUncertainty& uncertainty,
                        cv::Mat* missed);

struct SilhouetteCheck {
  MaskCheck given;
  // Masks whose false gaps have been filled, and borders moved.
  MaskCheck repaired;
  // Missed pixels of the repaired masks (CV_8UC1, 255), one per view.
  std::vector<cv::Mat> missed;
};

// `rays` of the mesh in unit coordinates. `given` and `repaired` are the same
// views; those that share a mask are compared once. `views` are prepared from
// `repaired`, with poses that may be better. `uncertainties` are one per view.
// The same figures for any number of threads.
SilhouetteCheck CheckSilhouettes(
    const RayScene& rays,
    const std::vector<View>& given,
    const std::vector<View>& repaired,
    const ViewSet& views,
    const std::vector<MaskUncertainty>& uncertainties,
    const Context& context);

}  // namespace octacut
