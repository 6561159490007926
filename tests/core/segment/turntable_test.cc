#include "core/segment/turntable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/hash.h"

namespace octacut {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 150;
// What a vase in front of the plate covers.
const cv::Rect kVase(80, 25, 40, 105);

// Patches of four by four pixels and noise of two grey levels.
cv::Mat Textured(uint64_t seed, const cv::Vec3b& base, uint64_t noise_seed) {
  cv::Mat image(kHeight, kWidth, CV_8UC3);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double patch =
            80 * HashUniform(HashBits(seed, y / 4, x / 4, c)) - 40;
        const double noise = 4 * HashUniform(HashBits(noise_seed, y, x, c)) - 2;
        image.at<cv::Vec3b>(y, x)[c] =
            cv::saturate_cast<uint8_t>(base[c] + patch + noise);
      }
    }
  }
  return image;
}

// A still background of blue patches, a round plate whose pattern changes, and
// on it what the test draws.
class TurntableTest : public ::testing::Test {
 protected:
  static cv::Mat PlateMask() {
    cv::Mat mask = cv::Mat::zeros(kHeight, kWidth, CV_8U);
    cv::ellipse(mask, {100, 120}, {60, 22}, 0, 0, 360, 255, cv::FILLED);
    return mask;
  }
  static cv::Mat Photograph(int i, bool with_plate) {
    cv::Mat image = Textured(1, {150, 90, 60}, 100 + uint64_t(i));
    if (with_plate) {
      Textured(1000 + uint64_t(i), {60, 90, 120}, 200 + uint64_t(i))
          .copyTo(image, PlateMask());
    }
    return image;
  }
  static double Overlap(const cv::Mat& a, const cv::Mat& b) {
    return double(cv::countNonZero(a & b)) / cv::countNonZero(a | b);
  }
  static std::vector<TurntableView> Segment(const TurntableInput& input) {
    std::vector<TurntableView> views = SegmentTurntable(input, Context(2));
    EXPECT_EQ(views.size(), input.images.size());
    return views;
  }
  // In all photographs, without a doubt.
  static void ExpectMasks(const std::vector<TurntableView>& views,
                          const std::vector<cv::Mat>& truths,
                          double least_overlap) {
    for (size_t i = 0; i < views.size(); ++i) {
      EXPECT_EQ(views[i].doubt, "") << i;
      EXPECT_GT(Overlap(views[i].mask, truths[i]), least_overlap) << i;
    }
  }
  static void ExpectVaseAndPlate(const TurntableInput& input) {
    cv::Mat truth = PlateMask();
    truth(kVase).setTo(255);
    ExpectMasks(
        Segment(input), std::vector<cv::Mat>(input.images.size(), truth), 0.95);
  }
};

TEST_F(TurntableTest, FindsWhatTurns) {
  TurntableInput input;
  std::vector<cv::Mat> truths;
  for (int i = 0; i < 16; ++i) {
    cv::Mat image = Photograph(i, true);
    cv::Mat truth = PlateMask();
    // An arm that swings from one side to the other.
    cv::Mat arm = cv::Mat::zeros(kHeight, kWidth, CV_8U);
    cv::line(arm, {100, 110}, {40 + 8 * i, 40}, 255, 14);
    Textured(3000 + uint64_t(i), {40, 160, 160}, 7).copyTo(image, arm);
    truths.push_back(truth | arm);
    input.images.push_back(image);
  }
  const std::vector<TurntableView> views = Segment(input);
  ExpectMasks(views, truths, 0.93);
  // The same bytes for any number of threads.
  const std::vector<TurntableView> again = SegmentTurntable(input, Context(1));
  EXPECT_EQ(cv::norm(views[3].mask, again[3].mask, cv::NORM_INF), 0);
}

// A grey vase that never changes stands in front of the plate.
TEST_F(TurntableTest, FindsAnObjectThatLooksTheSameFromAllSides) {
  TurntableInput input;
  for (int i = 0; i < 12; ++i) {
    cv::Mat image = Photograph(i, true);
    image(kVase).setTo(cv::Scalar(170, 170, 170));
    input.images.push_back(image);
  }
  ExpectVaseAndPlate(input);
  // With photographs of the empty set it may look like the background
  // elsewhere.
  input.empty_set = {Photograph(50, true), Photograph(51, true)};
  ExpectVaseAndPlate(input);
  // The share of all of 27 is not 1 in floats.
  for (int i = 52; i < 77; ++i) {
    input.empty_set.push_back(Photograph(i, true));
  }
  ExpectVaseAndPlate(input);
}

// The shades of a plain vase pass into each other, and many photographs agree
// on each.
TEST_F(TurntableTest, FindsAPlainObjectThatTurnsInTheLight) {
  TurntableInput input;
  for (int i = 0; i < 24; ++i) {
    cv::Mat image = Photograph(i, true);
    for (int y = kVase.y; y < kVase.br().y; ++y) {
      for (int x = kVase.x; x < kVase.br().x; ++x) {
        const double shade =
            190 + 25 * std::cos(2 * CV_PI * i / 24 + 0.05 * (x - kVase.x));
        image.at<cv::Vec3b>(y, x) =
            cv::Vec3b::all(cv::saturate_cast<uint8_t>(shade));
      }
    }
    input.images.push_back(image);
  }
  ExpectVaseAndPlate(input);
}

// An arm of a plain object hides the wall beside it in all but three
// photographs.
TEST_F(TurntableTest, FindsTheBackgroundThatAPlainObjectHides) {
  TurntableInput input;
  std::vector<cv::Mat> truths;
  for (int i = 0; i < 24; ++i) {
    cv::Mat truth = PlateMask();
    cv::Mat object = cv::Mat::zeros(truth.size(), CV_8U);
    object(kVase).setTo(255);
    if (i < 10 || i > 12) {
      object(cv::Rect(120, 30, 30 + 5 * (i % 3), 50)).setTo(255);
    }
    cv::Mat image = Photograph(i, true);
    image.setTo(cv::Scalar::all(120 + 5 * i), object);
    truths.push_back(truth | object);
    input.images.push_back(image);
  }
  ExpectMasks(Segment(input), truths, 0.95);
}

// Of a vase and a plate that look the same from all sides, only highlights
// differ.
TEST_F(TurntableTest, DoubtsPieces) {
  TurntableInput input;
  for (int i = 0; i < 12; ++i) {
    cv::Mat image = Photograph(i, false);
    image(kVase).setTo(cv::Scalar(40, 40, 40));
    for (int k = 0; k < 4; ++k) {
      image(cv::Rect(82 + 2 * i, 30 + 24 * k, 10, 10))
          .setTo(cv::Scalar(220, 220, 220));
    }
    input.images.push_back(image);
  }
  for (const TurntableView& view : Segment(input)) {
    EXPECT_NE(view.doubt.find("falls into pieces"), std::string::npos);
  }
}

// What stands still in front of the plate and looks like the background is not
// decided in silence.
TEST_F(TurntableTest, DoubtsWhatLooksLikeTheBackground) {
  TurntableInput input;
  for (int i = 0; i < 12; ++i) {
    cv::Mat image = Photograph(i, true);
    Textured(77, {150, 90, 60}, 300 + uint64_t(i))(kVase).copyTo(image(kVase));
    input.images.push_back(image);
  }
  for (const TurntableView& view : Segment(input)) {
    EXPECT_NE(view.doubt.find("background_path"), std::string::npos);
  }
}

TEST_F(TurntableTest, RefusesWhatIsNoTurntable) {
  TurntableInput still;
  TurntableInput moving;
  for (int i = 0; i < 6; ++i) {
    still.images.push_back(Photograph(i, false));
    moving.images.push_back(Textured(uint64_t(i), {120, 120, 120}, 5));
  }
  const auto message = [](const TurntableInput& input) -> std::string {
    try {
      SegmentTurntable(input, Context(2));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message(still).find("show the same"), std::string::npos);
  EXPECT_NE(message(moving).find("stands still"), std::string::npos);
}

}  // namespace
}  // namespace octacut
