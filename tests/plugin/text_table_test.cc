#include "plugin/text_table.h"

#include <gtest/gtest.h>

namespace octacut {
namespace {

TEST(TextTable, AlignsColumns) {
  TextTable table({"name", "count", "x"});
  table.AddRow({"a long one", "7", "1.50"});
  table.AddRow({"b", "12345678"});
  EXPECT_EQ(table.ToString(),
            "name           count     x\n"
            "--------------------------\n"
            "a long one         7  1.50\n"
            "b           12345678\n");
}

TEST(TextTable, CountsCharactersNotBytes) {
  TextTable table({"n", "v"});
  table.AddRow({"\xc3\xa4\xc3\xb6", "1"});
  table.AddRow({"abc", "2"});
  EXPECT_EQ(table.ToString(),
            "n    v\n"
            "------\n"
            "\xc3\xa4\xc3\xb6   1\n"
            "abc  2\n");
}

}  // namespace
}  // namespace octacut
