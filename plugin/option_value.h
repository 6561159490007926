// Values of options as text and as JSON: bool, integers, floating point,
// strings, paths; std::array and std::vector of numbers as comma-separated
// lists.
//
// Parsing throws OptionError with the constraint that the text does not meet
// ("must be an integer"), without the option's name, which the caller adds.
// It is independent of the locale.
#pragma once

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <concepts>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/error.h"

namespace octacut {

using Json = nlohmann::ordered_json;

template <typename T>
concept OptionInteger = std::integral<T> && !std::same_as<T, bool>;
template <typename T>
concept OptionNumber = OptionInteger<T> || std::floating_point<T>;

// The fields of a comma-separated list without surrounding blanks.
std::vector<std::string_view> SplitList(std::string_view text);

void ParseOptionValue(std::string_view text, bool* value);
void ParseOptionValue(std::string_view text, double* value);
void ParseOptionValue(std::string_view text, float* value);
void ParseOptionValue(std::string_view text, std::string* value);
void ParseOptionValue(std::string_view text, std::filesystem::path* value);

template <OptionInteger T>
void ParseOptionValue(std::string_view text, T* value) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, *value);
  if (error == std::errc::result_out_of_range) {
    throw OptionError(fmt::format("must be between {} and {}",
                                  std::numeric_limits<T>::min(),
                                  std::numeric_limits<T>::max()));
  }
  if (error != std::errc() || stop != end) {
    throw OptionError(std::is_signed_v<T> ? "must be an integer"
                                          : "must be an integer, at least 0");
  }
}

template <OptionNumber T, size_t N>
void ParseOptionValue(std::string_view text, std::array<T, N>* value) {
  const std::vector<std::string_view> fields = SplitList(text);
  if (fields.size() != N) {
    throw OptionError(fmt::format("must be {} numbers separated by commas", N));
  }
  for (size_t i = 0; i < N; ++i) {
    ParseOptionValue(fields[i], &(*value)[i]);
  }
}

template <OptionNumber T>
void ParseOptionValue(std::string_view text, std::vector<T>* value) {
  value->clear();
  for (const std::string_view field : SplitList(text)) {
    ParseOptionValue(field, &value->emplace_back());
  }
}

// The text that ParseOptionValue reads back.
std::string FormatOptionValue(bool value);
std::string FormatOptionValue(const std::string& value);
std::string FormatOptionValue(const std::filesystem::path& value);

template <OptionNumber T>
std::string FormatOptionValue(T value) {
  return fmt::format("{}", value);
}

template <OptionNumber T, size_t N>
std::string FormatOptionValue(const std::array<T, N>& value) {
  return fmt::format("{}", fmt::join(value, ","));
}

template <OptionNumber T>
std::string FormatOptionValue(const std::vector<T>& value) {
  return fmt::format("{}", fmt::join(value, ","));
}

template <typename T>
Json OptionValueToJson(const T& value) {
  return value;
}
inline Json OptionValueToJson(const std::filesystem::path& value) {
  return value.string();
}

}  // namespace octacut
