#include "colmap_io/images/image_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/colmap_io/images/test_workspace.h"

namespace octacut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ImageListTest : public testing::FolderTest {
 protected:
  std::vector<std::string> Keep(const std::string& text) {
    const std::filesystem::path path = folder_ / "list.txt";
    testing::WriteText(path, text);
    SparseModel model;
    for (const char* name : {"a.jpg", "far/b c.jpg", "c.jpg"}) {
      model.images.emplace_back().name = name;
    }
    KeepListedImages(path, &model);
    std::vector<std::string> names;
    for (const SparseImage& image : model.images) {
      names.push_back(image.name);
    }
    return names;
  }
};

TEST_F(ImageListTest, KeepsTheModelsOrder) {
  EXPECT_THAT(Keep("c.jpg\r\n\n  far/b c.jpg \nc.jpg"),
              ElementsAre("far/b c.jpg", "c.jpg"));
}

TEST_F(ImageListTest, SkipsAByteOrderMark) {
  EXPECT_THAT(Keep("\xEF\xBB\xBF"
                   "a.jpg\r\nc.jpg\r\n"),
              ElementsAre("a.jpg", "c.jpg"));
}

TEST_F(ImageListTest, UnknownName) {
  EXPECT_THAT(InputErrorOf([&] { Keep("a.jpg\n\nd.jpg\n"); }),
              HasSubstr("list.txt:3: d.jpg: the model has no such image"));
}

TEST_F(ImageListTest, NothingListed) {
  EXPECT_THAT(InputErrorOf([&] { Keep(" \n"); }),
              HasSubstr("list.txt: the file lists no images"));
  SparseModel model;
  EXPECT_THAT(
      InputErrorOf([&] { KeepListedImages(folder_ / "none.txt", &model); }),
      HasSubstr("none.txt: the file cannot be read"));
  EXPECT_THAT(InputErrorOf([&] { KeepListedImages(folder_, &model); }),
              HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace octacut
