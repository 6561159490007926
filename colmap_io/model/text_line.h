// Fields of one line of a text file, read in the C locale.
// Private to this folder.
#pragma once

#include <charconv>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

namespace octacut {

class TextLines;

// The fields of a line, separated by blanks. Valid until the next line is
// read.
class TextFields {
 public:
  TextFields(std::string_view line, const TextLines& lines)
      : rest_(line), lines_(&lines) {
    SkipBlanks();
  }

  bool AtEnd() const { return rest_.empty(); }

  // The next field; refused when there is none.
  std::string_view Word(std::string_view field);

  // The next field as a number, all of it.
  template <typename T>
  T Number(std::string_view field) {
    std::string_view word = Word(field);
    std::string_view digits = word;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') {
      digits.remove_prefix(1);
    }
    T value{};
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) {
      RefuseNumber(field,
                   word,
                   std::is_integral_v<T>,
                   error == std::errc::result_out_of_range);
    }
    return value;
  }

  // Everything that is left, without blanks at its end.
  std::string_view Rest();

 private:
  void SkipBlanks() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t')) {
      rest_.remove_prefix(1);
    }
  }
  [[noreturn]] void RefuseNumber(std::string_view field,
                                 std::string_view word,
                                 bool is_integer,
                                 bool out_of_range) const;

  std::string_view rest_;
  const TextLines* lines_;
};

// Lines of a stream with their numbers, without their ends (LF or CR LF) and
// without blanks at their ends.
class TextLines {
 public:
  TextLines(std::istream& stream, std::string name)
      : stream_(stream), name_(std::move(name)) {}
  TextLines(const TextLines&) = delete;
  TextLines& operator=(const TextLines&) = delete;

  // The next line whatever it holds; false at the end of the stream.
  bool Next();
  // The next line that is neither empty nor a comment (#).
  bool NextContent();

  std::string_view Line() const { return line_; }
  TextFields Fields() const { return {line_, *this}; }

  const std::string& Name() const { return name_; }
  // "<file>:<line>"
  std::string Where() const;
  [[noreturn]] void Fail(std::string_view message) const;

 private:
  std::istream& stream_;
  std::string name_;
  std::string buffer_;
  std::string_view line_;
  size_t number_ = 0;
};

}  // namespace octacut
