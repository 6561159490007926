// Words and numbers of text formats, whatever the locale of the process.
#pragma once

#include <charconv>
#include <cstdint>
#include <string_view>

namespace octacut {

// Takes the next word off the front of `text`; empty at its end.
inline std::string_view NextWord(std::string_view* text) {
  const auto is_space = [](char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  };
  size_t begin = 0;
  while (begin < text->size() && is_space((*text)[begin])) {
    ++begin;
  }
  size_t end = begin;
  while (end < text->size() && !is_space((*text)[end])) {
    ++end;
  }
  const std::string_view word = text->substr(begin, end - begin);
  text->remove_prefix(end);
  return word;
}

// True when the whole of `word` is a number that fits.
template <typename Number>
bool ParseNumber(std::string_view word, Number* value) {
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
  }
  const char* const end = word.data() + word.size();
  const std::from_chars_result result =
      std::from_chars(word.data(), end, *value);
  return result.ec == std::errc() && result.ptr == end && !word.empty();
}

}  // namespace octacut
