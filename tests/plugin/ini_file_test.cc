#include "plugin/ini_file.h"

#include <gtest/gtest.h>

#include <sstream>

#include "core/base/error.h"

namespace octacut {
namespace {

std::vector<IniEntry> Read(const std::string& text) {
  std::istringstream stream(text);
  return ReadIni(stream, "x.ini");
}

std::string ErrorOf(const std::string& text) {
  try {
    Read(text);
  } catch (const OptionError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadIni, TopLevelKeysAndSections) {
  const auto entries = Read(
      "# A project.\n"
      "workspace_path=/a b/c#1\n"
      "\n"
      "  random_seed\t=  7   # seven\r\n"
      "[Group]\n"
      "x=1=2\n"
      "[ Other ]\n"
      "empty=\n");
  ASSERT_EQ(entries.size(), 4u);
  EXPECT_EQ(entries[0].key, "workspace_path");
  EXPECT_EQ(entries[0].value, "/a b/c#1");
  EXPECT_EQ(entries[0].line, 2);
  EXPECT_EQ(entries[1].key, "random_seed");
  EXPECT_EQ(entries[1].value, "7");
  EXPECT_EQ(entries[1].line, 4);
  EXPECT_EQ(entries[2].key, "Group.x");
  EXPECT_EQ(entries[2].value, "1=2");
  EXPECT_EQ(entries[3].key, "Other.empty");
  EXPECT_EQ(entries[3].value, "");
  EXPECT_EQ(entries[3].line, 8);
}

TEST(ReadIni, AcceptsMissingLastNewlineAndByteOrderMark) {
  const auto entries = Read(
      "\xEF\xBB\xBF"
      "a=1\nb=2");
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].key, "a");
  EXPECT_EQ(entries[1].value, "2");
  EXPECT_TRUE(Read("").empty());
}

TEST(ReadIni, NamesFileAndLineOfNonsense) {
  EXPECT_EQ(ErrorOf("a=1\nnonsense\n"),
            "x.ini:2: expected `key=value`, not `nonsense`");
  EXPECT_EQ(ErrorOf("=1\n"), "x.ini:1: expected `key=value`, not `=1`");
  EXPECT_EQ(ErrorOf("[Group\n"), "x.ini:1: expected `key=value`, not `[Group`");
}

}  // namespace
}  // namespace octacut
