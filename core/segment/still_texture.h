// Background with texture that a plain object hides in most photographs.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/segment/still_background.h"

namespace octacut {

// CV_8UC1, 0 or 255, of a photograph.
struct StillTexture {
  cv::Mat sure;  // background, by its texture
  cv::Mat near;  // what stands still around it
};

// Least number of photographs.
inline constexpr size_t kLeastForStillTexture = 5;

// `labs`, of a camera that stands still, are as ToLab makes them and in the
// order in which the object turned once; `background` is theirs. What two of
// the four photographs that are some 10 and 20 degrees away show at the same
// pixels as well stands still, and is background if its texture has more than
// one direction and is not that of the most frequent colours: the texture of
// the plate moves, a plain object has none, and its contours are lines
// (docs/experiments/mask_turntables.md).
std::vector<StillTexture> FindStillTexture(std::span<const cv::Mat> labs,
                                           const StillBackground& background,
                                           const Context& context);

}  // namespace octacut
