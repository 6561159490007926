#include "colmap_io/images/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "colmap_io/files/read_file.h"
#include "colmap_io/images/image_header.h"
#include "core/base/error.h"
#include "core/scene/scene.h"

namespace octacut {
namespace {

constexpr int kMaxLabels = 8;

cv::Mat Decode(const std::filesystem::path& path,
               const std::string& bytes,
               int flags) {
  if (IsTruncatedJpeg(bytes)) {
    throw InputError(fmt::format("{}: the file is truncated", path.string()));
  }
  cv::Mat pixels;
  try {
    if (!bytes.empty()) {
      // Some decoders (WebP) refuse `char`, which is signed.
      pixels = cv::imdecode(
          cv::_InputArray(reinterpret_cast<const uint8_t*>(bytes.data()),
                          int(bytes.size())),
          flags | cv::IMREAD_IGNORE_ORIENTATION);
    }
  } catch (const cv::Exception& exception) {
    throw InputError(fmt::format(
        "{}: the image cannot be decoded ({})", path.string(), exception.err));
  }
  if (pixels.empty()) {
    throw InputError(
        fmt::format("{}: the image cannot be decoded; it is damaged or has an "
                    "unknown format",
                    path.string()));
  }
  return pixels;
}

// The channel that says what is object, in a pixel of `channels` values.
template <typename T>
T MaskValue(const T* pixel, int channels, bool use_alpha) {
  if (use_alpha) {
    return pixel[channels - 1];
  }
  const int colours = channels == 4 || channels == 2 ? channels - 1 : channels;
  return *std::max_element(pixel, pixel + colours);
}

template <typename T>
bool HasTransparency(const cv::Mat& pixels) {
  const int channels = pixels.channels();
  if (channels != 4 && channels != 2) {
    return false;
  }
  for (int y = 0; y < pixels.rows; ++y) {
    const T* row = pixels.ptr<T>(y);
    for (int x = 0; x < pixels.cols; ++x) {
      if (row[x * channels + channels - 1] != std::numeric_limits<T>::max()) {
        return true;
      }
    }
  }
  return false;
}

// One channel of 8 bits; what is not zero stays so.
template <typename T>
cv::Mat ToOneByte(const cv::Mat& pixels) {
  const int channels = pixels.channels();
  if (channels == 1 && sizeof(T) == 1) {
    return pixels.clone();
  }
  const bool use_alpha = HasTransparency<T>(pixels);
  cv::Mat_<T> values(pixels.size());
  T largest = 0;
  for (int y = 0; y < pixels.rows; ++y) {
    const T* row = pixels.ptr<T>(y);
    for (int x = 0; x < pixels.cols; ++x) {
      const T value =
          MaskValue(row + size_t(x) * channels, channels, use_alpha);
      values(y, x) = value;
      largest = std::max(largest, value);
    }
  }
  if constexpr (sizeof(T) == 1) {
    return values;
  } else {
    const int shift = largest > 255 ? 8 : 0;
    cv::Mat_<uint8_t> bytes(pixels.size());
    std::transform(values.begin(), values.end(), bytes.begin(), [&](T value) {
      return uint8_t(value == 0 ? 0 : std::max(1, value >> shift));
    });
    return bytes;
  }
}

// What becomes of each value of a mask.
std::array<uint8_t, 256> MaskTable(const cv::Mat& values, bool from_jpeg) {
  std::array<bool, 256> present{};
  for (int y = 0; y < values.rows; ++y) {
    const uint8_t* row = values.ptr<uint8_t>(y);
    for (int x = 0; x < values.cols; ++x) {
      present[row[x]] = true;
    }
  }
  const auto distinct = std::count(present.begin(), present.end(), true);
  int largest = 255;
  while (largest > 0 && !present[largest]) {
    --largest;
  }
  std::array<uint8_t, 256> table{};
  for (int value = 1; value < 256; ++value) {
    if (from_jpeg) {
      table[value] = value >= kObjectThreshold ? 255 : 0;
    } else if (distinct <= kMaxLabels) {
      table[value] = 255;
    } else if (largest < 128) {
      table[value] = uint8_t(std::min(255, value * 255 / largest));
    } else {
      table[value] = uint8_t(value);
    }
  }
  return table;
}

}  // namespace

cv::Mat ReadPhotograph(const std::filesystem::path& path) {
  return Decode(path, ReadFile(path), cv::IMREAD_COLOR);
}

cv::Mat ReadGrey(const std::filesystem::path& path) {
  return Decode(path, ReadFile(path), cv::IMREAD_GRAYSCALE);
}

cv::Mat ReadMask(const std::filesystem::path& path) {
  const std::string bytes = ReadFile(path);
  const cv::Mat pixels = Decode(path, bytes, cv::IMREAD_UNCHANGED);
  if (pixels.depth() != CV_8U && pixels.depth() != CV_16U) {
    throw InputError(fmt::format(
        "{}: a mask must have 8 or 16 bits per channel", path.string()));
  }
  return MaskFromPixels(pixels, IsJpeg(bytes));
}

cv::Mat MaskFromPixels(const cv::Mat& pixels, bool from_jpeg) {
  cv::Mat mask = pixels.depth() == CV_8U ? ToOneByte<uint8_t>(pixels)
                                         : ToOneByte<uint16_t>(pixels);
  const std::array<uint8_t, 256> table = MaskTable(mask, from_jpeg);
  for (int y = 0; y < mask.rows; ++y) {
    uint8_t* row = mask.ptr<uint8_t>(y);
    for (int x = 0; x < mask.cols; ++x) {
      row[x] = table[row[x]];
    }
  }
  return mask;
}

}  // namespace octacut
