// A mask's border to the pixel, in the photograph itself.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>

namespace octacut {

// Bytes for each pixel of an image that RefineBorder and its caller need, at
// most: photograph and masks 6, and of a window that is the whole image, Lab
// colours, lightness, roughness and features 36, distances 8.
inline constexpr size_t kRefineBorderBytesPerPixel = 50;
// What a loop over images may take: two photographs of 12 megapixels at once.
inline constexpr size_t kRefineBorderBudget = size_t{3} << 29;

// Moves the border of `mask` (CV_8UC1, 0 or 255, of the size of `image`,
// CV_8UC3) to where the photograph has it: by the minimal cut, in a band of
// `reach` pixels to either side, between the colours just inside and just
// outside of the first band. Where the new border ends at the limits of its
// band, a band around it is cut again. Large reaches are worked off from coarse
// to fine. `labels` (CV_8UC1 of that size, or empty) say which pixels are
// surroundings or object for sure.
cv::Mat RefineBorder(const cv::Mat& image,
                     const cv::Mat& mask,
                     double reach,
                     const cv::Mat& labels = {});

}  // namespace octacut
