#include "colmap_io/benchmark/crop_polygon_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "tests/colmap_io/files/temporary_folder.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const char kVolume[] = R"({
  "axis_max": 2.5, "axis_min": -1,
  "bounding_polygon": [[0, 0, 0], [4, 0, 0], [4, 0, 3], [0, 0, 3]],
  "class_name": "SelectionPolygonVolume", "orthogonal_axis": "Y",
  "version_major": 1, "version_minor": 0})";

TEST(ReadCropPolygon, AVolumeOfOpen3D) {
  const TemporaryFolder folder;
  const CropPolygon crop = ReadCropPolygon(folder.Write("a.json", kVolume));
  EXPECT_EQ(crop.axis, 1);
  EXPECT_EQ(crop.polygon.size(), 4u);
  EXPECT_TRUE(crop.Contains({1, 2.4, 1}));
  EXPECT_FALSE(crop.Contains({1, 2.6, 1}));
  EXPECT_FALSE(crop.Contains({5, 0, 1}));
}

TEST(ReadCropPolygon, MistakesAreNamed) {
  const TemporaryFolder folder;
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = kVolume;
    text.replace(text.find(from), from.size(), to);
    return folder.Write("b.json", text);
  };
  const std::pair<std::string, const char*> cases[] = {
      {folder.Write("b.json", "{"), "b.json: is not a JSON file"},
      {folder / "gone.json", "gone.json: the file cannot be read"},
  };
  for (const auto& mistake : cases) {
    EXPECT_THAT([&] { ReadCropPolygon(mistake.first); },
                ThrowsMessage<InputError>(HasSubstr(mistake.second)));
  }
  const std::tuple<const char*, const char*, const char*> edits[] = {
      {"\"Y\"", "\"W\"", "orthogonal_axis: must be X, Y or Z, is \"W\""},
      {"axis_min", "other", "axis_min: is missing"},
      {"2.5", "\"x\"", "axis_max: must be a number, is \"x\""},
      {"2.5", "-3", "axis_max: must be greater"},
      {"[4, 0, 0]", "[4, 0]", "bounding_polygon: must hold points"},
      {"[4, 0, 0], [4, 0, 3], ", "", "at least three points"},
  };
  for (const auto& edit : edits) {
    const auto read = [&] {
      ReadCropPolygon(with(std::get<0>(edit), std::get<1>(edit)));
    };
    const char* message = std::get<2>(edit);
    EXPECT_THAT(read, ThrowsMessage<InputError>(HasSubstr(message)));
  }
}

}  // namespace
}  // namespace octacut
