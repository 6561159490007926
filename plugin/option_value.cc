#include "plugin/option_value.h"

#include <cmath>

#include "colmap_io/files/trim.h"

namespace octacut {
namespace {

template <typename T>
void ParseFloatingPoint(std::string_view text, T* value) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, *value);
  if (error != std::errc() || stop != end || !std::isfinite(*value)) {
    throw OptionError("must be a finite number");
  }
}

}  // namespace

std::vector<std::string_view> SplitList(std::string_view text) {
  std::vector<std::string_view> fields;
  if (Trim(text).empty()) {
    return fields;
  }
  for (size_t begin = 0; begin != std::string_view::npos;) {
    const size_t comma = text.find(',', begin);
    fields.push_back(Trim(text.substr(begin, comma - begin)));
    begin = comma == std::string_view::npos ? comma : comma + 1;
  }
  return fields;
}

void ParseOptionValue(std::string_view text, bool* value) {
  if (text == "1" || text == "true") {
    *value = true;
  } else if (text == "0" || text == "false") {
    *value = false;
  } else {
    throw OptionError("must be 0 or 1");
  }
}

void ParseOptionValue(std::string_view text, double* value) {
  ParseFloatingPoint(text, value);
}

void ParseOptionValue(std::string_view text, float* value) {
  ParseFloatingPoint(text, value);
}

void ParseOptionValue(std::string_view text, std::string* value) {
  *value = text;
}

void ParseOptionValue(std::string_view text, std::filesystem::path* value) {
  *value = text;
}

std::string FormatOptionValue(bool value) { return value ? "1" : "0"; }
std::string FormatOptionValue(const std::string& value) { return value; }
std::string FormatOptionValue(const std::filesystem::path& value) {
  return value.string();
}

}  // namespace octacut
