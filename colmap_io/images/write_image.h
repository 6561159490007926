// Pictures to files.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "colmap_io/files/atomic_files.h"

namespace octacut {

// Throws OptionError "<option> = <path>: ..." unless it ends with .png, .jpg or
// .jpeg, in any case.
void CheckImagePath(const std::string& option,
                    const std::filesystem::path& path);

// Encodes by extension (.png, .jpg, .jpeg); `parameters` as cv::imencode takes
// them. The file appears whole or not at all. Throws InputError naming it.
void WriteImage(const std::filesystem::path& path,
                const cv::Mat& image,
                const std::vector<int>& parameters = {});
// Together with `files`, when these are committed.
void WriteImage(const std::filesystem::path& path,
                const cv::Mat& image,
                AtomicFiles* files,
                const std::vector<int>& parameters = {});

}  // namespace octacut
