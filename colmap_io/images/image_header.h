// The size of a picture from its header alone, and whether its data ends
// early: what image libraries do not tell or only print.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string_view>

namespace octacut {

struct ImageSize {
  uint64_t width = 0;  // pixels, as stored: EXIF orientation not applied
  uint64_t height = 0;

  bool operator==(const ImageSize&) const = default;
};

// The size of a PNG or JPEG image; empty for other formats and for damaged
// headers. Reads no pixels.
std::optional<ImageSize> ReadImageSize(std::istream& stream);

// True for a JPEG file whose data stops before its end marker: decoders fill
// the rest with grey and say nothing.
bool IsTruncatedJpeg(std::string_view file);

bool IsJpeg(std::string_view file);

}  // namespace octacut
