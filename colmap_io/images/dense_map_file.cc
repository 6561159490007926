#include "colmap_io/images/dense_map_file.h"

#include <fmt/format.h>

#include <opencv2/core.hpp>
#include <ostream>
#include <vector>

#include "colmap_io/files/atomic_files.h"

namespace octacut {

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

}  // namespace octacut
