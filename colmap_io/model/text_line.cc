#include "colmap_io/model/text_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "colmap_io/files/byte_order_mark.h"
#include "colmap_io/files/trim.h"
#include "core/base/error.h"

namespace octacut {
namespace {

// A word as a message shows it: not endless.
std::string Shown(std::string_view word) {
  constexpr size_t kMaxShown = 40;
  if (word.size() <= kMaxShown) return std::string(word);
  return std::string(word.substr(0, kMaxShown)) + "...";
}

}  // namespace

std::string_view TextFields::Word(std::string_view field) {
  if (rest_.empty()) {
    lines_->Fail(fmt::format("the line ends before {}", field));
  }
  const size_t size = std::min(rest_.find_first_of(kBlanks), rest_.size());
  const std::string_view word = rest_.substr(0, size);
  rest_.remove_prefix(size);
  SkipBlanks();
  return word;
}

std::string_view TextFields::Rest() {
  const std::string_view rest = rest_;
  rest_ = {};
  return rest;
}

void TextFields::RefuseNumber(std::string_view field,
                              std::string_view word,
                              bool is_integer,
                              bool out_of_range) const {
  lines_->Fail(fmt::format("{} = \"{}\": {}",
                           field,
                           Shown(word),
                           out_of_range ? "out of range"
                           : is_integer ? "must be a whole number"
                                        : "must be a number"));
}

bool TextLines::Next() {
  if (!std::getline(stream_, buffer_)) return false;
  ++number_;
  line_ = buffer_;
  if (number_ == 1) SkipByteOrderMark(&line_);
  line_ = TrimEnd(line_);
  return true;
}

bool TextLines::NextContent() {
  while (Next()) {
    const size_t first = line_.find_first_not_of(kBlanks);
    if (first != std::string_view::npos && line_[first] != '#') return true;
  }
  return false;
}

std::string TextLines::Where() const {
  return fmt::format("{}:{}", name_, number_);
}

void TextLines::Fail(std::string_view message) const {
  throw InputError(fmt::format("{}: {}", Where(), message));
}

}  // namespace octacut
