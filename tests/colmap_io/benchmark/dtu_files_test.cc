#include "colmap_io/benchmark/dtu_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_io/files/read_file.h"
#include "core/base/error.h"
#include "tests/colmap_io/benchmark/mat_writer.h"
#include "tests/colmap_io/files/temporary_folder.h"

namespace octacut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class ReadDtuCropTest : public ::testing::Test {
 protected:
  // 2 x 1 x 3 cells, of which (1, 0, 2) is observed.
  std::string Mask(double resolution = 4) const {
    std::string path = folder_ / "ObsMask1_10.mat";
    MatWriter writer(path);
    writer.Logicals("ObsMask", {2, 1, 3}, {0, 0, 0, 0, 0, 1});
    // In MATLAB's order, column after column.
    writer.Doubles("BB", {2, 3}, {-1, 9, -2, 8, -3, 7});
    writer.Doubles("Res", {1, 1}, {resolution});
    return path;
  }
  std::string Plane(const std::vector<double>& values = {0, 0, 1, -5}) const {
    std::string path = folder_ / "Plane1.mat";
    MatWriter(path).Doubles("P", {values.size(), 1}, values);
    return path;
  }

  TemporaryFolder folder_;
};

TEST_F(ReadDtuCropTest, MaskAndPlaneInAnyOrder) {
  for (const bool mask_first : {true, false}) {
    const DtuCrop crop = mask_first ? ReadDtuCrop({Mask(), Plane()})
                                    : ReadDtuCrop({Plane(), Mask()});
    EXPECT_EQ(crop.plane, Eigen::Vector4d(0, 0, 1, -5));
    EXPECT_THAT(crop.mask.size, ElementsAre(2, 1, 3));
    EXPECT_EQ(crop.mask.box_min, Eigen::Vector3d(-1, -2, -3));
    EXPECT_EQ(crop.mask.box_max, Eigen::Vector3d(9, 8, 7));
    EXPECT_EQ(crop.mask.cell_size, 4);
    EXPECT_TRUE(crop.mask.Contains({3, -2, 5}));
    EXPECT_FALSE(crop.mask.Contains({-1, -2, 5}));
    EXPECT_FALSE(crop.mask.Contains({3, -2, 1}));
    EXPECT_FALSE(crop.mask.Contains({3, 3, 5}));
  }
}

TEST_F(ReadDtuCropTest, MistakesAreNamed) {
  EXPECT_THAT([&] { ReadDtuCrop({Mask()}); },
              ThrowsMessage<OptionError>(HasSubstr("Plane<scan>.mat")));
  EXPECT_THAT([&] { ReadDtuCrop({Plane()}); },
              ThrowsMessage<OptionError>(HasSubstr("ObsMask<scan>_10.mat")));
  EXPECT_THAT(
      [&] {
        ReadDtuCrop({Plane(), Plane()});
      },
      ThrowsMessage<InputError>(HasSubstr("may be given once")));
  EXPECT_THAT(
      [&] {
        ReadDtuCrop({Plane({1, 2, 3})});
      },
      ThrowsMessage<InputError>(
          HasSubstr("Plane1.mat: variable P: must have 4 numbers")));
  EXPECT_THAT(
      [&] {
        ReadDtuCrop({Mask(0), Plane()});
      },
      ThrowsMessage<InputError>(HasSubstr("variable Res")));
  for (const std::filesystem::path& path :
       {folder_.Write("text.mat", "no MATLAB file"), folder_ / "gone.mat"}) {
    EXPECT_THAT([&] { ReadDtuCrop({path}); },
                ThrowsMessage<InputError>(HasSubstr(path.string())));
  }
  // Cut off in the middle.
  const std::string whole = ReadFile(Mask());
  const std::string cut =
      folder_.Write("cut.mat", whole.substr(0, whole.size() - 60));
  EXPECT_THROW(ReadDtuCrop({cut, Plane()}), InputError);
}

}  // namespace
}  // namespace octacut
