#include "core/views/image_pyramid.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace octacut {
namespace {

constexpr int kSmallestSide = 8;

PyramidLevel PackFullResolution(const cv::Mat& image, const cv::Mat& mask) {
  PyramidLevel level;
  level.width = image.cols;
  level.height = image.rows;
  level.texels.resize(size_t(level.width) * level.height);
  for (int y = 0; y < level.height; ++y) {
    const uint8_t* colors = image.ptr<uint8_t>(y);
    const uint8_t* coverage = mask.ptr<uint8_t>(y);
    uint32_t* texels = level.texels.data() + size_t(y) * level.width;
    for (int x = 0; x < level.width; ++x) {
      const uint8_t* const color = colors + 3 * size_t(x);
      texels[x] = uint32_t(color[0]) | uint32_t(color[1]) << 8 |
                  uint32_t(color[2]) << 16 | uint32_t(coverage[x]) << 24;
    }
  }
  return level;
}

PyramidLevel Halve(const PyramidLevel& fine) {
  PyramidLevel coarse;
  coarse.width = (fine.width + 1) / 2;
  coarse.height = (fine.height + 1) / 2;
  coarse.scale = fine.scale / 2;
  coarse.texels.resize(size_t(coarse.width) * coarse.height);
  for (int y = 0; y < coarse.height; ++y) {
    const uint32_t* row0 = fine.texels.data() + size_t(2 * y) * fine.width;
    const uint32_t* row1 = 2 * y + 1 < fine.height ? row0 + fine.width : row0;
    for (int x = 0; x < coarse.width; ++x) {
      const int x0 = 2 * x;
      const int x1 = std::min(x0 + 1, fine.width - 1);
      uint32_t texel = 0;
      for (int shift = 0; shift < 32; shift += 8) {
        const auto byte = [&](uint32_t t) { return (t >> shift) & 255; };
        const uint32_t sum =
            byte(row0[x0]) + byte(row0[x1]) + byte(row1[x0]) + byte(row1[x1]);
        texel |= ((sum + 2) / 4) << shift;
      }
      coarse.texels[size_t(y) * coarse.width + x] = texel;
    }
  }
  return coarse;
}

}  // namespace

ImagePyramid::ImagePyramid(const cv::Mat& image, const cv::Mat& mask) {
  if (image.type() != CV_8UC3 || mask.type() != CV_8UC1 ||
      image.size() != mask.size() || image.cols < 2 || image.rows < 2) {
    throw InvariantError(fmt::format(
        "an image pyramid needs an 8-bit colour image and a mask of one size "
        "of at least 2x2 pixels, not {}x{} and {}x{}",
        image.cols,
        image.rows,
        mask.cols,
        mask.rows));
  }
  levels_.push_back(PackFullResolution(image, mask));
  while (std::min(levels_.back().width, levels_.back().height) >=
         2 * kSmallestSide) {
    levels_.push_back(Halve(levels_.back()));
  }
}

}  // namespace octacut
