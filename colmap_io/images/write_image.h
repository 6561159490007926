// Pictures to files.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace octacut {

// Encodes by extension (.png, .jpg); `parameters` as cv::imencode takes them.
// The file appears whole or not at all. Throws InputError naming it.
void WriteImage(const std::filesystem::path& path,
                const cv::Mat& image,
                const std::vector<int>& parameters = {});

}  // namespace octacut
