// Photographs and masks from files. What is stored counts: EXIF orientation is
// never applied, since COLMAP's cameras and keypoints do not know it either.
//
// Everything throws InputError naming the file when it cannot be read or
// decoded or is damaged.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

namespace octacut {

// CV_8UC3, BGR. Grey pictures become colour, 16 bits become 8, alpha is
// dropped.
cv::Mat ReadPhotograph(const std::filesystem::path& path);

// CV_8UC1, as it is stored.
cv::Mat ReadGrey(const std::filesystem::path& path);

// CV_8UC1 as View::mask: 255 = object, 0 = background, coverage between.
//
// A mask may be grey, of colours (a pixel is its largest channel), with an
// alpha channel (which is the mask then, unless it is opaque everywhere), of 8
// or 16 bits.
// - JPEG: object where above 127, since compression blurs edges.
// - At most eight different values (0 / 255, 0 / 1, labels, trimaps): object
//   where not zero, as COLMAP has it.
// - More values: antialiased; coverage as it is, scaled so that the largest
//   value is 255 when that is below 128.
cv::Mat ReadMask(const std::filesystem::path& path);

// The mask that a decoded picture stands for, as above. `pixels` of 8 or 16
// bits and 1 to 4 channels, of 2 and 4 the last one alpha.
cv::Mat MaskFromPixels(const cv::Mat& pixels, bool from_jpeg);

}  // namespace octacut
