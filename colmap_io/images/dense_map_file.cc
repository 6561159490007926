#include "colmap_io/images/dense_map_file.h"

#include <fmt/format.h>

#include <fstream>
#include <opencv2/core.hpp>
#include <ostream>
#include <vector>

#include "colmap_io/files/atomic_files.h"
#include "core/base/error.h"

namespace octacut {
namespace {

constexpr int kMaxSide = 100'000;

}  // namespace

void WriteDenseMap(const std::filesystem::path& path, const cv::Mat& map) {
  std::vector<cv::Mat> channels;
  cv::split(map, channels);
  WriteFile(path, [&](std::ostream& stream) {
    stream << fmt::format("{}&{}&{}&", map.cols, map.rows, channels.size());
    for (const cv::Mat& channel : channels) {
      for (int y = 0; y < channel.rows; ++y) {
        stream.write(reinterpret_cast<const char*>(channel.ptr<float>(y)),
                     std::streamsize(sizeof(float)) * channel.cols);
      }
    }
  });
}

cv::Mat ReadDenseMap(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  int width = 0;
  int height = 0;
  int num_channels = 0;
  char mark[3] = {};
  if (!(stream >> width >> mark[0] >> height >> mark[1] >> num_channels) ||
      !stream.get(mark[2]) || mark[0] != '&' || mark[1] != '&' ||
      mark[2] != '&') {
    throw InputError(
        fmt::format("{}: no depth or normal map of COLMAP: the header must be "
                    "width&height&channels&",
                    path.string()));
  }
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide ||
      (num_channels != 1 && num_channels != 3)) {
    throw InputError(fmt::format("{}: a map of {} x {} x {} values",
                                 path.string(),
                                 width,
                                 height,
                                 num_channels));
  }
  std::vector<cv::Mat> channels;
  for (int i = 0; i < num_channels; ++i) {
    cv::Mat& channel = channels.emplace_back(height, width, CV_32FC1);
    if (!stream.read(channel.ptr<char>(),
                     std::streamsize(sizeof(float)) * width * height)) {
      throw InputError(fmt::format("{}: the file ends early", path.string()));
    }
  }
  cv::Mat map;
  cv::merge(channels, map);
  return map;
}

}  // namespace octacut
