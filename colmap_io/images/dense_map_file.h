// Depth and normal maps in COLMAP's format (mvs/mat.h): the ASCII header
// "width&height&channels&", then 32-bit floats, channel after channel, each row
// by row.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

namespace octacut {

// CV_32FC1 or CV_32FC3. The file appears whole or not at all.
void WriteDenseMap(const std::filesystem::path& path, const cv::Mat& map);

}  // namespace octacut
