#include "colmap_io/images/image_header.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

namespace octacut {
namespace {

constexpr std::array<uint8_t, 8> kPngSignature = {
    0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a};

template <size_t N>
bool ReadArray(std::istream& stream, std::array<uint8_t, N>* bytes) {
  stream.read(reinterpret_cast<char*>(bytes->data()), N);
  return bool(stream);
}

uint64_t BigEndian(const uint8_t* bytes, int count) {
  uint64_t value = 0;
  for (int i = 0; i < count; ++i) {
    value = value << 8 | bytes[i];
  }
  return value;
}

// Markers that no length follows: restarts, begin of image, TEM.
bool IsBareMarker(uint8_t marker) {
  return marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
}
// Start of frame: holds the size. DHT (c4), JPG (c8) and DAC (cc) are others.
bool IsStartOfFrame(uint8_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 &&
         marker != 0xcc;
}

// `stream` is behind the first marker, ff d8.
std::optional<ImageSize> ReadJpegSize(std::istream& stream) {
  std::array<uint8_t, 1> byte{};
  while (ReadArray(stream, &byte)) {
    if (byte[0] != 0xff) {
      return {};
    }
    do {
      if (!ReadArray(stream, &byte)) {
        return {};
      }
    } while (byte[0] == 0xff);
    const uint8_t marker = byte[0];
    if (IsBareMarker(marker)) {
      continue;
    }
    std::array<uint8_t, 2> length{};
    if (!ReadArray(stream, &length) || BigEndian(length.data(), 2) < 2) {
      return {};
    }
    if (IsStartOfFrame(marker)) {
      std::array<uint8_t, 5> frame{};  // precision, height, width
      if (!ReadArray(stream, &frame)) {
        return {};
      }
      return ImageSize{BigEndian(&frame[3], 2), BigEndian(&frame[1], 2)};
    }
    stream.seekg(std::streamoff(BigEndian(length.data(), 2)) - 2,
                 std::ios::cur);
  }
  return {};
}

}  // namespace

std::optional<ImageSize> ReadImageSize(std::istream& stream) {
  std::array<uint8_t, 2> magic{};
  if (!ReadArray(stream, &magic)) {
    return {};
  }
  if (magic[0] == 0xff && magic[1] == 0xd8) {
    return ReadJpegSize(stream);
  }
  // PNG: signature, then the chunk IHDR (length, type, width, height).
  std::array<uint8_t, 22> rest{};
  if (magic[0] != kPngSignature[0] || magic[1] != kPngSignature[1] ||
      !ReadArray(stream, &rest) ||
      !std::equal(
          kPngSignature.begin() + 2, kPngSignature.end(), rest.begin()) ||
      std::memcmp(&rest[10], "IHDR", 4) != 0) {
    return {};
  }
  return ImageSize{BigEndian(&rest[14], 4), BigEndian(&rest[18], 4)};
}

bool IsJpeg(std::string_view file) { return file.starts_with("\xff\xd8\xff"); }

bool IsTruncatedJpeg(std::string_view file) {
  if (!IsJpeg(file)) {
    return false;
  }
  const std::span bytes(reinterpret_cast<const uint8_t*>(file.data()),
                        file.size());
  // Skip the segments up to the first scan: those of EXIF may hold a thumbnail
  // with an end marker of its own.
  size_t at = 2;
  while (at + 4 <= bytes.size() && bytes[at] == 0xff) {
    const uint8_t marker = bytes[at + 1];
    if (marker == 0xff || IsBareMarker(marker)) {
      at += marker == 0xff ? 1 : 2;
      continue;
    }
    at += 2 + size_t(BigEndian(&bytes[at + 2], 2));
    if (marker == 0xda) {
      break;
    }
  }
  // In scans ff is followed by 00 or a marker, so ff d9 is the end.
  for (; at + 1 < bytes.size(); ++at) {
    if (bytes[at] == 0xff && bytes[at + 1] == 0xd9) {
      return false;
    }
  }
  return true;
}

}  // namespace octacut
