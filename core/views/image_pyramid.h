// Image pyramids of a view, sampled at a voxel's footprint.
//
// A texel packs blue, green, red and the silhouette's coverage in one 32-bit
// word, so one load serves a whole sample. Level k of the pyramid has pixels
// of 2^k x 2^k original ones (box filter, border replicated), so a pixel
// coordinate u of the image is u / 2^k there, exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace octacut {

using Float4 = float __attribute__((vector_size(16)));

// Sum of the first three elements.
inline float SumChannels(Float4 v) { return v[0] + v[1] + v[2]; }

// The colour, or difference of colours, with what is not grey of it times
// `chroma_weight`: gloss adds the lamp's white to the colour of the object
// (Shafer 1985, the dichromatic reflection model), so chroma differs less than
// brightness between views. The fourth element stays.
inline Float4 WeightChroma(Float4 color, float chroma_weight) {
  const Float4 grey =
      (color + __builtin_shufflevector(color, color, 1, 2, 0, 3) +
       __builtin_shufflevector(color, color, 2, 0, 1, 3)) *
      (1.0f / 3);
  return grey + chroma_weight * (color - grey);
}

struct PyramidLevel {
  std::vector<uint32_t> texels;  // row-major
  int width = 0;
  int height = 0;
  float scale = 1;  // 2^-k

  // Bilinear sample at pixel coordinates of the full image (centre of the
  // first pixel at 0.5): blue, green, red, coverage in 0 .. 255. Outside the
  // frame the border is repeated.
  Float4 Sample(float u, float v) const {
    const float x = std::clamp(u * scale - 0.5f, 0.0f, float(width - 1));
    const float y = std::clamp(v * scale - 0.5f, 0.0f, float(height - 1));
    const int x0 = std::min(int(x), width - 2);
    const int y0 = std::min(int(y), height - 2);
    const float fx = x - float(x0);
    const float fy = y - float(y0);
    const uint32_t* row = texels.data() + size_t(y0) * width + x0;
    const Float4 top = Unpack(row[0]) * (1 - fx) + Unpack(row[1]) * fx;
    const Float4 bottom =
        Unpack(row[width]) * (1 - fx) + Unpack(row[width + 1]) * fx;
    return top * (1 - fy) + bottom * fy;
  }

  // In steps of twice the width, which are an instruction each; converted at
  // once, the bytes would be taken apart one by one.
  static Float4 Unpack(uint32_t texel) {
    using Byte16 = uint8_t __attribute__((vector_size(16)));
    using Short8 = uint16_t __attribute__((vector_size(16)));
    using Word4 = uint32_t __attribute__((vector_size(16)));
    using Int4 = int32_t __attribute__((vector_size(16)));
    const Byte16 bytes = Byte16(Word4{texel, 0, 0, 0});
    // clang-format off
    const Short8 shorts = Short8(__builtin_shufflevector(
        bytes, Byte16{},
        0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23));
    // clang-format on
    const Int4 words = Int4(
        __builtin_shufflevector(shorts, Short8{}, 0, 8, 1, 9, 2, 10, 3, 11));
    return __builtin_convertvector(words, Float4);
  }
};

class ImagePyramid {
 public:
  ImagePyramid() = default;
  // `image` CV_8UC3 and `mask` CV_8UC1 of one size, at least 2x2. Levels go
  // down to a smaller side of some 8 pixels.
  ImagePyramid(const cv::Mat& image, const cv::Mat& mask);

  int NumLevels() const { return int(levels_.size()); }
  const PyramidLevel& Level(int level) const { return levels_[level]; }
  // The level whose pixels are closest to `footprint` original pixels.
  const PyramidLevel& LevelForFootprint(float footprint) const {
    const int level = int(std::lround(std::log2(std::max(footprint, 1.0f))));
    return levels_[std::min(level, NumLevels() - 1)];
  }

 private:
  std::vector<PyramidLevel> levels_;
};

}  // namespace octacut
