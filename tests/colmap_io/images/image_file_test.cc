#include "colmap_io/images/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "colmap_io/images/image_header.h"
#include "tests/colmap_io/images/test_workspace.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;

using testing::Texture;
using testing::WritePicture;
using testing::WriteText;

class ImageFileTest : public testing::FolderTest {};

std::string Slurp(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

// A mask of one row with these values.
cv::Mat MaskOf(const std::vector<int>& values,
               int depth = CV_8U,
               bool from_jpeg = false) {
  cv::Mat pixels(1, int(values.size()), CV_MAKETYPE(depth, 1));
  for (size_t i = 0; i < values.size(); ++i) {
    if (depth == CV_8U) {
      pixels.at<uint8_t>(0, int(i)) = uint8_t(values[i]);
    } else {
      pixels.at<uint16_t>(0, int(i)) = uint16_t(values[i]);
    }
  }
  return MaskFromPixels(pixels, from_jpeg);
}

void ExpectMask(const cv::Mat& mask, const std::vector<int>& values) {
  ASSERT_EQ(mask.type(), CV_8UC1);
  ASSERT_EQ(mask.total(), values.size());
  for (size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(mask.at<uint8_t>(0, int(i)), values[i]) << "value " << i;
  }
}

TEST(MaskFromPixels, AnythingButZeroIsObjectInLabels) {
  ExpectMask(MaskOf({0, 255}), {0, 255});
  ExpectMask(MaskOf({0, 1}), {0, 255});
  ExpectMask(MaskOf({0, 1, 2, 3, 100, 128, 255}),
             {0, 255, 255, 255, 255, 255, 255});
  ExpectMask(MaskOf({0, 1, 7}, CV_16U), {0, 255, 255});
  ExpectMask(MaskOf({0, 65535, 1}, CV_16U), {0, 255, 255});
}

TEST(MaskFromPixels, ManyValuesAreCoverage) {
  const std::vector<int> ramp = {0, 10, 50, 100, 127, 128, 160, 200, 240, 255};
  ExpectMask(MaskOf(ramp), ramp);
  // A file that uses a part of the range.
  ExpectMask(MaskOf({0, 1, 5, 20, 30, 49, 50, 51, 90, 100}),
             {0, 2, 12, 51, 76, 124, 127, 130, 229, 255});
  std::vector<int> wide;
  wide.reserve(ramp.size());
  for (int value : ramp) {
    wide.push_back(value * 257);
  }
  ExpectMask(MaskOf(wide, CV_16U), ramp);
}

TEST(MaskFromPixels, JpegIsThresholded) {
  ExpectMask(MaskOf({0, 3, 127, 128, 250}, CV_8U, true), {0, 0, 0, 255, 255});
}

TEST(MaskFromPixels, ColoursAndAlpha) {
  cv::Mat colours(1, 3, CV_8UC3, cv::Scalar(0, 0, 0));
  colours.at<cv::Vec3b>(0, 1) = {0, 0, 9};
  ExpectMask(MaskFromPixels(colours, false), {0, 255, 0});
  // Opaque: the colours count.
  cv::Mat opaque(1, 2, CV_8UC4, cv::Scalar(0, 0, 0, 255));
  opaque.at<cv::Vec4b>(0, 1) = {255, 255, 255, 255};
  ExpectMask(MaskFromPixels(opaque, false), {0, 255});
  // A cut-out photograph of something black: alpha counts.
  cv::Mat cut_out(1, 2, CV_8UC4, cv::Scalar(0, 0, 0, 255));
  cut_out.at<cv::Vec4b>(0, 1) = {200, 200, 200, 0};
  ExpectMask(MaskFromPixels(cut_out, false), {255, 0});
}

TEST_F(ImageFileTest, ReadsGrey16BitAndAlphaAsColour) {
  const cv::Mat colour = Texture(32, 24);
  WritePicture(folder_ / "colour.png", colour);
  EXPECT_EQ(cv::norm(ReadPhotograph(folder_ / "colour.png"), colour), 0);

  cv::Mat grey(24, 32, CV_8UC1, cv::Scalar(77));
  WritePicture(folder_ / "grey.png", grey);
  const cv::Mat read = ReadPhotograph(folder_ / "grey.png");
  ASSERT_EQ(read.type(), CV_8UC3);
  EXPECT_EQ(read.at<cv::Vec3b>(3, 5), cv::Vec3b(77, 77, 77));

  cv::Mat deep(24, 32, CV_16UC3, cv::Scalar(257 * 10, 257 * 20, 257 * 200));
  WritePicture(folder_ / "deep.png", deep);
  const cv::Mat shallow = ReadPhotograph(folder_ / "deep.png");
  ASSERT_EQ(shallow.type(), CV_8UC3);
  EXPECT_EQ(shallow.at<cv::Vec3b>(3, 5), cv::Vec3b(10, 20, 200));

  cv::Mat alpha(24, 32, CV_8UC4, cv::Scalar(1, 2, 3, 0));
  WritePicture(folder_ / "alpha.png", alpha);
  const cv::Mat dropped = ReadPhotograph(folder_ / "alpha.png");
  ASSERT_EQ(dropped.type(), CV_8UC3);
  EXPECT_EQ(dropped.at<cv::Vec3b>(3, 5), cv::Vec3b(1, 2, 3));
}

TEST_F(ImageFileTest, ReadsWebP) {
  const cv::Mat colour = Texture(32, 24);
  // Above 100: without loss.
  ASSERT_TRUE(cv::imwrite((folder_ / "colour.webp").string(),
                          colour,
                          {cv::IMWRITE_WEBP_QUALITY, 101}));
  EXPECT_EQ(cv::norm(ReadPhotograph(folder_ / "colour.webp"), colour), 0);
}

// A JPEG whose EXIF says "turn by 90 degrees".
std::string WithOrientation(const std::string& jpeg, char orientation) {
  std::string exif("Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0",
                   25);
  exif += orientation;
  exif += std::string(6, '\0');
  const size_t length = exif.size() + 2;
  return jpeg.substr(0, 2) + "\xff\xe1" + char(length >> 8) + char(length) +
         exif + jpeg.substr(2);
}

TEST_F(ImageFileTest, DoesNotApplyExifOrientation) {
  WritePicture(folder_ / "plain.jpg", Texture(32, 24));
  const std::string plain = Slurp(folder_ / "plain.jpg");
  WriteText(folder_ / "turned.jpg", WithOrientation(plain, 6));
  // OpenCV would turn it.
  const cv::Mat turned = cv::imread((folder_ / "turned.jpg").string());
  ASSERT_EQ(turned.cols, 24);
  const cv::Mat read = ReadPhotograph(folder_ / "turned.jpg");
  EXPECT_EQ(read.cols, 32);
  EXPECT_EQ(read.rows, 24);
  EXPECT_EQ(ReadMask(folder_ / "turned.jpg").cols, 32);
  std::stringstream stream(WithOrientation(plain, 6));
  EXPECT_EQ(ReadImageSize(stream), (ImageSize{32, 24}));
}

TEST_F(ImageFileTest, RefusesWhatIsNoWholePicture) {
  WritePicture(folder_ / "whole.jpg", Texture(320, 240));
  WritePicture(folder_ / "whole.png", Texture(320, 240));
  const std::string jpeg = Slurp(folder_ / "whole.jpg");
  const std::string png = Slurp(folder_ / "whole.png");
  for (const double part : {0.02, 0.3, 0.7, 0.99}) {
    WriteText(folder_ / "part.jpg", jpeg.substr(0, size_t(part * jpeg.size())));
    EXPECT_THAT(InputErrorOf([&] { ReadPhotograph(folder_ / "part.jpg"); }),
                HasSubstr("part.jpg"))
        << part;
    EXPECT_THAT(InputErrorOf([&] { ReadGrey(folder_ / "part.jpg"); }),
                HasSubstr("part.jpg"))
        << part;
    WriteText(folder_ / "part.png", png.substr(0, size_t(part * png.size())));
    EXPECT_THAT(InputErrorOf([&] { ReadMask(folder_ / "part.png"); }),
                HasSubstr("part.png"))
        << part;
  }
  WriteText(folder_ / "empty.png", "");
  EXPECT_THAT(InputErrorOf([&] { ReadPhotograph(folder_ / "empty.png"); }),
              HasSubstr("empty.png"));
  WriteText(folder_ / "text.jpg", "this is no picture");
  EXPECT_THAT(InputErrorOf([&] { ReadPhotograph(folder_ / "text.jpg"); }),
              HasSubstr("text.jpg"));
  EXPECT_THAT(InputErrorOf([&] { ReadMask(folder_ / "none.png"); }),
              HasSubstr("none.png"));
}

TEST_F(ImageFileTest, ReadsSizesFromHeaders) {
  for (const char* name : {"a.png", "a.jpg"}) {
    WritePicture(folder_ / name, Texture(321, 123));
    std::ifstream stream(folder_ / name, std::ios::binary);
    EXPECT_EQ(ReadImageSize(stream), (ImageSize{321, 123})) << name;
    // Any truncated header is unknown or right, never wrong.
    const std::string bytes = Slurp(folder_ / name);
    for (size_t size = 0; size < 700 && size < bytes.size(); ++size) {
      std::stringstream part(bytes.substr(0, size));
      const auto found = ReadImageSize(part);
      if (found) {
        EXPECT_EQ(*found, (ImageSize{321, 123}));
      }
    }
  }
  std::stringstream other("BM..............................");
  EXPECT_FALSE(ReadImageSize(other).has_value());
}

}  // namespace
}  // namespace octacut
