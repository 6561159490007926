#include "core/segment/still_texture.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/base/hash.h"

namespace octacut {
namespace {

constexpr int kStillWidth = 120;
constexpr int kStillHeight = 90;
constexpr float kTolerance = 8;
const cv::Rect kStillPatch(40, 30, 40, 30);
const cv::Scalar kGrey(150, 128, 128);

// Lab of a plain surface.
cv::Mat PlainLab() { return {kStillHeight, kStillWidth, CV_8UC3, kGrey}; }

// Squares of four pixels, of all shades.
cv::Mat StillPattern() {
  cv::Mat lab = PlainLab();
  for (int y = 0; y < kStillHeight; ++y) {
    for (int x = 0; x < kStillWidth; ++x) {
      lab.at<cv::Vec3b>(y, x)[0] =
          uint8_t(90 + 120 * HashUniform(HashBits(1, y / 4, x / 4)));
    }
  }
  return lab;
}

StillBackground MostFrequent(const cv::Mat& lab) {
  StillBackground background;
  lab.convertTo(background.color, CV_32F);
  background.tolerance = kTolerance;
  return background;
}

// Photographs that show `seen` within the patch from the first one on, and
// `usual` in the others.
std::vector<cv::Mat> Turn(int count,
                          int num_seen,
                          const cv::Mat& seen,
                          const cv::Mat& usual) {
  std::vector<cv::Mat> labs;
  for (int i = 0; i < count; ++i) {
    labs.push_back(usual.clone());
    if (i < num_seen) {
      seen(kStillPatch).copyTo(labs.back()(kStillPatch));
    }
  }
  return labs;
}

double PartOfPatch(const cv::Mat& mask) {
  return double(cv::countNonZero(mask(kStillPatch))) / kStillPatch.area();
}

TEST(StillTexture, FindsTextureThatThreePhotographsShow) {
  const auto labs = Turn(36, 3, StillPattern(), PlainLab());
  const StillBackground background = MostFrequent(PlainLab());
  for (const size_t i : {0, 1, 2}) {
    const StillTexture found = FindStillTexture(labs, i, background);
    EXPECT_GT(PartOfPatch(found.sure), 0.9) << i;
    EXPECT_EQ(cv::countNonZero(found.sure & ~found.near), 0) << i;
  }
  EXPECT_EQ(cv::countNonZero(FindStillTexture(labs, 20, background).sure), 0);
}

TEST(StillTexture, ComparesPhotographsThatAreTenDegreesApart) {
  // Three of 72 are within 10 degrees, five are not.
  const StillBackground background = MostFrequent(PlainLab());
  const auto few = Turn(72, 3, StillPattern(), PlainLab());
  EXPECT_EQ(cv::countNonZero(FindStillTexture(few, 1, background).sure), 0);
  const auto more = Turn(72, 5, StillPattern(), PlainLab());
  EXPECT_GT(PartOfPatch(FindStillTexture(more, 2, background).sure), 0.9);
}

TEST(StillTexture, CreasesAndContoursAreNone) {
  cv::Mat crease = PlainLab();
  cv::line(crease, {0, 40}, {kStillWidth, 60}, {70, 128, 128}, 5);
  const std::vector<cv::Mat> labs(36, crease);
  const StillTexture found =
      FindStillTexture(labs, 1, MostFrequent(PlainLab()));
  EXPECT_EQ(PartOfPatch(found.sure), 0);
}

TEST(StillTexture, TextureOfTheMostFrequentColoursIsNone) {
  // The same highlights on a surface that became brighter.
  const cv::Mat brighter = StillPattern() + cv::Scalar(2 * kTolerance, 0, 0);
  const auto labs = Turn(36, 3, brighter, StillPattern());
  const StillTexture found =
      FindStillTexture(labs, 1, MostFrequent(StillPattern()));
  EXPECT_LT(PartOfPatch(found.sure), 0.1);
}

TEST(StillTexture, FourPhotographsAreTooFew) {
  const auto labs = Turn(4, 4, StillPattern(), PlainLab());
  const StillTexture found =
      FindStillTexture(labs, 1, MostFrequent(PlainLab()));
  EXPECT_EQ(cv::countNonZero(found.sure | found.near), 0);
}

}  // namespace
}  // namespace octacut
