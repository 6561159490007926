// The byte order mark that editors of other systems put in front of UTF-8.
#pragma once

#include <string_view>

namespace octacut {

// Removes it from the first line of a text file.
inline void SkipByteOrderMark(std::string_view* line) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (line->starts_with(kMark)) {
    line->remove_prefix(kMark.size());
  }
}

}  // namespace octacut
