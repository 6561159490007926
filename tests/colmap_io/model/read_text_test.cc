// Text readers on what people and other programs write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <sstream>

#include "colmap_io/model/read_sparse_model.h"
#include "tests/colmap_io/model/test_models.h"
#include "tests/colmap_io/model/text_model.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;

std::vector<SparseCamera> Cameras(const std::string& text) {
  std::istringstream stream(text);
  return ReadCamerasText(stream, "cameras.txt");
}
std::vector<SparseImage> Images(const std::string& text) {
  std::istringstream stream(text);
  return ReadImagesText(stream, "images.txt");
}
std::vector<SparsePoint> Points(const std::string& text) {
  std::istringstream stream(text);
  return ReadPointsText(stream, "points3D.txt");
}

TEST(ReadText, CommentsBlanksAndLineEndings) {
  const auto cameras = Cameras(
      "\xEF\xBB\xBF# made by hand\r\n\r\n  # more\r\n"
      "3 PINHOLE 640 480 +500 5.1e2\t320.5   240 \r\n"
      "1 SIMPLE_RADIAL 640 480 500 320 240 -0.1");
  ASSERT_EQ(cameras.size(), 2u);
  EXPECT_EQ(cameras[0].id, 3u);
  EXPECT_EQ(cameras[0].params, (std::vector<double>{500, 510, 320.5, 240}));
  EXPECT_EQ(cameras[1].model_id, camera_model::kSimpleRadial);
  EXPECT_EQ(cameras[1].params[3], -0.1);
}

TEST(ReadText, ImagesWithAndWithoutObservations) {
  const auto images = Images(
      "# comment\n"
      "2 1 0 0 0 1 2 3 1 a b/\xC3\xBC"
      "ber.jpg\r\n"
      "\r\n"
      "1 2 0 0 0 1 2 3 1 second.png\n"
      "1.5 2.5 -1 3 4 17 5 6 18446744073709551615\n"
      "# comment\n"
      "9 0 1 0 0 1 2 3 1 last.png");
  ASSERT_EQ(images.size(), 3u);
  EXPECT_EQ(images[0].name,
            "a b/\xC3\xBC"
            "ber.jpg");
  EXPECT_TRUE(images[0].observations.empty());
  EXPECT_EQ(images[1].rotation.w(), 1);
  ASSERT_EQ(images[1].observations.size(), 3u);
  EXPECT_FALSE(images[1].observations[0].HasPoint());
  EXPECT_EQ(images[1].observations[1].point3D_id, 17u);
  EXPECT_FALSE(images[1].observations[2].HasPoint());
  EXPECT_EQ(images[2].name, "last.png");
  EXPECT_EQ(images[2].CamFromWorld().rotation.diagonal(),
            Eigen::Vector3d(1, -1, -1));
}

TEST(ReadText, AnEmptyFileOfPointsIsNoPoints) {
  EXPECT_TRUE(Points("").empty());
  EXPECT_TRUE(Points("# none\n").empty());
  const auto points = Points("5 1 2 3 255 0 7 -1\n6 1 2 3 1 2 3 nan 4 5 6 7\n");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].rgb, (std::array<uint8_t, 3>{255, 0, 7}));
  ASSERT_EQ(points[1].track.size(), 2u);
  EXPECT_EQ(points[1].track[1].point2D_index, 7u);
}

TEST(ReadText, RefusalsNameFileLineFieldAndValue) {
  const std::string pose = "1 0 0 0 1 2 3 1 ";
  const struct {
    std::string message;
    std::string expected;
  } cases[] = {
      {InputErrorOf([] { Cameras("\n1 PINHOLE 640 480 500 500 320"); }),
       "cameras.txt:2: camera 1: 3 parameters, but PINHOLE has 4"},
      {InputErrorOf([] { Cameras("1 PINHOLE 640 480 500 500 320 240 1"); }),
       "5 parameters"},
      {InputErrorOf([] { Cameras("1 PINHOLE 640,5 480 500 500 320 240"); }),
       "cameras.txt:1: width = \"640,5\": must be a whole number"},
      {InputErrorOf([] { Cameras("1 PINHOLE 640 480 500 500 320,5 240"); }),
       "a parameter = \"320,5\": must be a number"},
      {InputErrorOf([] { Cameras("1 PINHOLE 640 480 1e999 500 320 240"); }),
       "\"1e999\": out of range"},
      {InputErrorOf([] { Cameras("1 PINHOLE 640 480 inf 500 320 240"); }),
       "fx = inf: must be finite"},
      {InputErrorOf([] { Cameras("-1 PINHOLE 640 480 500 500 320 240"); }),
       "camera_id = \"-1\": must be a whole number"},
      {InputErrorOf([] { Cameras("4294967296 PINHOLE 640 480"); }),
       "camera_id = \"4294967296\": out of range"},
      {InputErrorOf([] { Cameras("1 CRYSTAL_BALL 640 480 1"); }),
       "cameras.txt:1: camera 1: camera model \"CRYSTAL_BALL\" is unknown"},
      {InputErrorOf([] { Cameras("1 EQUIRECTANGULAR 640 320 640 320"); }),
       "EQUIRECTANGULAR (17) is not a perspective camera"},
      {InputErrorOf([] { Cameras("1 PINHOLE 640"); }),
       "cameras.txt:1: the line ends before height"},
      {InputErrorOf([] { Images("1 1 0 0 0 1 2 3 1"); }),
       "images.txt:1: image 1: its name is missing"},
      {InputErrorOf([] { Images("1 0 0 0 0 1 2 3 1 a.png\n"); }),
       "images.txt:1: image 1 (a.png): quaternion"},
      {InputErrorOf([] { Images("1 1 0 0 0 1 nan 3 1 a.png\n"); }),
       "ty = nan: must be finite"},
      // The empty second line was left out.
      {InputErrorOf(
           [&] { Images("1 " + pose + "a.png\n2 " + pose + "b.png"); }),
       "images.txt:2: "},
      {InputErrorOf([&] { Images("1 " + pose + "a.png\n1 2 3 4 5"); }),
       "images.txt:2: the line ends before point3D_id"},
      {InputErrorOf([&] { Images("1 " + pose + "a.png\n1 2 -2"); }),
       "point3D_id = \"-2\""},
      {InputErrorOf([&] { Images("1 " + pose + "a.png\n1 inf 2"); }),
       "image 1: observation 0 at (1, inf)"},
      {InputErrorOf([] { Points("1 1 2 3 256 0 0 1"); }),
       "points3D.txt:1: r = \"256\": out of range"},
      {InputErrorOf([] { Points("1 1 2 x 0 0 0 1"); }),
       "z = \"x\": must be a number"},
      {InputErrorOf([] { Points("1 1 2 3 0 0 0 1 5"); }),
       "the line ends before a track's point2D_idx"},
      {InputErrorOf([] { Points("1 1 2 inf 0 0 0 1"); }), "must be finite"},
      {InputErrorOf([] { Points(std::string(100000, 'y')); }), "\"yyyy"},
  };
  for (const auto& c : cases) EXPECT_THAT(c.message, HasSubstr(c.expected));
  EXPECT_LT(std::end(cases)[-1].message.size(), 200u);
}

// Random damage never does worse than an InputError.
TEST(ReadText, SurvivesRandomDamage) {
  const SparseModel model = TestModel(3, 4, 6);
  const std::array texts = {CamerasText(model.cameras),
                            ImagesText(model.images),
                            PointsText(model.points)};
  std::mt19937 random(20240608);
  const std::string alphabet = "0123456789 -.e\n\r\t#xn\0\xff,";
  int num_refused = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text = texts[trial % 3];
    for (int i = int(random() % 4); i >= 0; --i) {
      text[random() % text.size()] = alphabet[random() % alphabet.size()];
    }
    if (random() % 4 == 0) text.resize(random() % text.size());
    num_refused += InputErrorOf([&] {
                     if (trial % 3 == 0) Cameras(text);
                     if (trial % 3 == 1) Images(text);
                     if (trial % 3 == 2) Points(text);
                   }) != "no InputError";
  }
  EXPECT_GT(num_refused, 300);
}

}  // namespace
}  // namespace octacut
