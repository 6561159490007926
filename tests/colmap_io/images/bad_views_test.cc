#include "colmap_io/images/bad_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/colmap_io/images/test_workspace.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<JudgedView> TwentyViews() {
  std::vector<JudgedView> views;
  for (int i = 0; i < 20; ++i) {
    const std::string name = std::to_string(i) + ".jpg";
    views.push_back({name, "masks/" + name + ".png"});
  }
  return views;
}

Contradictions OfViews(const std::vector<size_t>& numbers, bool is_grave) {
  Contradictions result;
  result.is_judged = true;
  for (const size_t number : numbers) {
    result.views.push_back({number, {0.125, 0.0375}, is_grave});
  }
  return result;
}

TEST(DecideOnBadViews, ATenthIsLeftOut) {
  testing::Recorder recorder;
  const BadViewSummary summary = DecideOnBadViews(
      OfViews({3, 7}, true), TwentyViews(), Context(1, &recorder));
  ASSERT_EQ(summary.views.size(), 2u);
  EXPECT_EQ(summary.views[0].name, "3.jpg");
  EXPECT_TRUE(summary.views[0].is_left_out);
  EXPECT_TRUE(summary.views[1].is_left_out);
  ASSERT_EQ(recorder.warnings.size(), 2u);
  EXPECT_THAT(recorder.warnings[1], HasSubstr("masks/7.jpg.png"));
  EXPECT_THAT(recorder.warnings[1], HasSubstr("12.5 %"));
  EXPECT_THAT(recorder.warnings[1], HasSubstr("3.8 %"));
  EXPECT_THAT(recorder.warnings[1], HasSubstr("--keep_all_views 1"));
}

TEST(DecideOnBadViews, MoreAreAnErrorThatListsThem) {
  const std::string error = InputErrorOf([] {
    DecideOnBadViews(OfViews({3, 7, 11}, true), TwentyViews(), Context(1));
  });
  EXPECT_THAT(error, HasSubstr("3 of 20 views"));
  for (const char* name : {"3.jpg.png", "7.jpg.png", "11.jpg.png"}) {
    EXPECT_THAT(error, HasSubstr(name));
  }
  EXPECT_THAT(error, HasSubstr("--keep_all_views 1"));
}

TEST(DecideOnBadViews, ManyThatShowMoreThanTheObjectAreUsed) {
  testing::Recorder recorder;
  const BadViewSummary summary = DecideOnBadViews(
      OfViews({3, 7, 11}, false), TwentyViews(), Context(1, &recorder));
  ASSERT_EQ(summary.views.size(), 3u);
  EXPECT_FALSE(summary.views[0].is_left_out);
  ASSERT_EQ(recorder.warnings.size(), 3u);
  EXPECT_THAT(recorder.warnings[0], HasSubstr("used nevertheless"));
}

TEST(DecideOnBadViews, NoneAreNoNews) {
  testing::Recorder recorder;
  const BadViewSummary summary =
      DecideOnBadViews(OfViews({}, true), TwentyViews(), Context(1, &recorder));
  EXPECT_TRUE(summary.is_judged);
  EXPECT_THAT(recorder.warnings, IsEmpty());
}

}  // namespace
}  // namespace octacut
