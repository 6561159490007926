// Text without the blanks around it.
#pragma once

#include <algorithm>
#include <string_view>

namespace octacut {

inline constexpr std::string_view kBlanks = " \t\r";

inline std::string_view TrimEnd(std::string_view text) {
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

inline std::string_view Trim(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return TrimEnd(text);
}

}  // namespace octacut
