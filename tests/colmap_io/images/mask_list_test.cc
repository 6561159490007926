#include "colmap_io/images/mask_list.h"

#include <gmock/gmock.h>

#include "tests/colmap_io/images/test_workspace.h"

namespace octacut::testing {
namespace {

using ::testing::HasSubstr;

class MaskListTest : public FolderTest {};

TEST_F(MaskListTest, IsReadAsItWasWritten) {
  MaskList list;
  list.views = {
      {"a/b.jpg", MaskStatus::kExtracted, "a/b.jpg.png", "12", 0.5, ""},
      {"c.jpg", MaskStatus::kUnsure, "", "", 0.25, "dark"},
      {"d.jpg", MaskStatus::kGiven, "mask_d.png", "ab", 1, ""}};
  WriteText(folder_ / "masks.json", MaskListText(list));
  const std::optional<MaskList> read = ReadMaskList(folder_);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->views.size(), 3u);
  EXPECT_EQ(read->Find("a/b.jpg")->mask, "a/b.jpg.png");
  EXPECT_EQ(read->Find("a/b.jpg")->confidence, 0.5);
  EXPECT_EQ(read->Find("c.jpg")->status, MaskStatus::kUnsure);
  EXPECT_EQ(read->Find("c.jpg")->doubt, "dark");
  EXPECT_EQ(read->Find("d.jpg")->hash, "ab");
  EXPECT_EQ(read->Find("e.jpg"), nullptr);
  EXPECT_EQ(read->Count(MaskStatus::kExtracted), 1u);
  EXPECT_EQ(read->Count(MaskStatus::kUnsure), 1u);
}

TEST_F(MaskListTest, NoListIsNoError) { EXPECT_FALSE(ReadMaskList(folder_)); }

TEST_F(MaskListTest, OtherFilesAreRefusedByName) {
  const auto refusal = [&](const std::string& text) {
    WriteText(folder_ / "masks.json", text);
    return InputErrorOf([&] { ReadMaskList(folder_); });
  };
  EXPECT_THAT(refusal("{"), HasSubstr("masks.json: this is no list"));
  EXPECT_THAT(refusal(R"({"program": "x", "views": []})"),
              HasSubstr("program is not"));
  EXPECT_THAT(refusal(R"({"program": "octacut mask_extractor", "views": [
                  {"image": "a.jpg", "status": "fine"}]})"),
              HasSubstr("status = fine"));
}

TEST_F(MaskListTest, AMaskIsOctacutsUntilItChanges) {
  WriteText(folder_ / "a.jpg.png", "bytes");
  MaskList list;
  list.views = {{"a.jpg",
                 MaskStatus::kExtracted,
                 "a.jpg.png",
                 HashOfBytes("bytes"),
                 1,
                 ""}};
  EXPECT_TRUE(IsExtractedMask(list, "a.jpg", folder_ / "a.jpg.png"));
  EXPECT_FALSE(IsExtractedMask({}, "a.jpg", folder_ / "a.jpg.png"));
  WriteText(folder_ / "a.jpg.png", "byteS");
  EXPECT_FALSE(IsExtractedMask(list, "a.jpg", folder_ / "a.jpg.png"));
}

}  // namespace
}  // namespace octacut::testing
