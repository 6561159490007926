#include "plugin/option_value.h"

#include <gtest/gtest.h>

namespace octacut {
namespace {

template <typename T>
T Parse(const std::string& text) {
  T value{};
  ParseOptionValue(text, &value);
  return value;
}

template <typename T>
std::string ErrorOf(const std::string& text) {
  try {
    Parse<T>(text);
  } catch (const OptionError& error) {
    return error.what();
  }
  return "";
}

TEST(OptionValue, Booleans) {
  EXPECT_TRUE(Parse<bool>("1"));
  EXPECT_TRUE(Parse<bool>("true"));
  EXPECT_FALSE(Parse<bool>("0"));
  EXPECT_FALSE(Parse<bool>("false"));
  for (const char* text : {"", "2", "yes", "1 ", "TRUE"}) {
    EXPECT_EQ(ErrorOf<bool>(text), "must be 0 or 1") << text;
  }
}

TEST(OptionValue, Integers) {
  EXPECT_EQ(Parse<int>("-1"), -1);
  EXPECT_EQ(Parse<uint64_t>("18446744073709551615"), UINT64_MAX);
  for (const char* text : {"", "1.5", "1e3", "x", "1x", " 1", "+1", "0x10"}) {
    EXPECT_EQ(ErrorOf<int>(text), "must be an integer") << text;
  }
  EXPECT_EQ(ErrorOf<int>("2147483648"),
            "must be between -2147483648 and 2147483647");
  EXPECT_EQ(ErrorOf<uint32_t>("-1"), "must be an integer, at least 0");
}

TEST(OptionValue, FloatingPoint) {
  EXPECT_EQ(Parse<double>("1e-5"), 1e-5);
  EXPECT_EQ(Parse<double>("-.5"), -0.5);
  EXPECT_EQ(Parse<float>("0.1"), 0.1f);
  for (const char* text : {"", "1,5", "nan", "inf", "1e999", "x", "1.5x"}) {
    EXPECT_EQ(ErrorOf<double>(text), "must be a finite number") << text;
  }
}

TEST(OptionValue, Lists) {
  using Six = std::array<double, 6>;
  EXPECT_EQ(Parse<Six>("-1,-2, -3,1,2,3.5"), (Six{-1, -2, -3, 1, 2, 3.5}));
  EXPECT_EQ(ErrorOf<Six>("1,2,3"), "must be 6 numbers separated by commas");
  EXPECT_EQ(ErrorOf<Six>(""), "must be 6 numbers separated by commas");
  EXPECT_EQ(ErrorOf<Six>("1,2,3,4,5,"), "must be a finite number");
  EXPECT_EQ(Parse<std::vector<int>>("4,5"), (std::vector<int>{4, 5}));
  EXPECT_TRUE(Parse<std::vector<int>>("").empty());
  EXPECT_EQ(ErrorOf<std::vector<int>>("4,,5"), "must be an integer");
}

TEST(OptionValue, Text) {
  EXPECT_EQ(Parse<std::string>("a b"), "a b");
  EXPECT_EQ(Parse<std::filesystem::path>("a/b c"), "a/b c");
}

// What help and report show can be given back.
TEST(OptionValue, FormatIsReadBack) {
  for (const double value : {1e-5, 0.1, -3.0, 1.0 / 3, 1e300}) {
    EXPECT_EQ(Parse<double>(FormatOptionValue(value)), value);
  }
  EXPECT_EQ(FormatOptionValue(1e-5), "1e-05");
  EXPECT_EQ(FormatOptionValue(true), "1");
  EXPECT_EQ(FormatOptionValue(std::array<double, 2>{1, 2.5}), "1,2.5");
  EXPECT_EQ(FormatOptionValue(std::vector<double>()), "");
  EXPECT_EQ(FormatOptionValue(std::filesystem::path("a/b")), "a/b");
}

TEST(OptionValue, Json) {
  EXPECT_EQ(OptionValueToJson(true), Json(true));
  EXPECT_EQ(OptionValueToJson(std::array<double, 2>{1, 2.5}).dump(),
            "[1.0,2.5]");
  EXPECT_EQ(OptionValueToJson(std::vector<double>()).dump(), "[]");
  EXPECT_EQ(OptionValueToJson(std::filesystem::path("a/b")).dump(), "\"a/b\"");
}

}  // namespace
}  // namespace octacut
