#include "colmap_io/images/saliency_network.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>

#include "colmap_io/images/onnx_input_size.h"
#include "core/base/error.h"
#include "tests/colmap_io/files/temporary_folder.h"
#include "tests/colmap_io/images/tiny_network.h"

namespace octacut {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::OnnxWriter;
using ::testing::ThrowsMessage;
using testing::TinyNetwork;

// Twice the size of the network's images; red at the left, blue at the right.
cv::Mat RedAndBlue() {
  cv::Mat image(64, 96, CV_8UC3, cv::Scalar(0, 0, 255));
  image.colRange(48, 96).setTo(cv::Scalar(255, 0, 0));
  return image;
}

class SaliencyNetworkTest : public ::testing::Test {
 protected:
  std::filesystem::path Written(const TinyNetwork& network) const {
    folder_.Write("n.onnx", OnnxWriter::Write(network));
    return folder_ / "n.onnx";
  }

  TemporaryFolder folder_;
};

TEST_F(SaliencyNetworkTest, GetsRedGreenBlueNormalised) {
  SaliencyNetwork network(
      Written({.weights = {1, 0.5f, -0.25f}, .bias = 0.125f}));
  EXPECT_EQ(network.InputSize(), cv::Size(48, 32));
  const cv::Mat saliency = network.Saliency(RedAndBlue());
  ASSERT_EQ(saliency.size(), cv::Size(96, 64));
  ASSERT_EQ(saliency.type(), CV_32F);
  const double red = (1 - 0.485) / 0.229 + 0.5 * (0 - 0.456) / 0.224 -
                     0.25 * (0 - 0.406) / 0.225 + 0.125;
  const double blue = (0 - 0.485) / 0.229 + 0.5 * (0 - 0.456) / 0.224 -
                      0.25 * (1 - 0.406) / 0.225 + 0.125;
  EXPECT_NEAR(saliency.at<float>(30, 20), 1 / (1 + std::exp(-red)), 1e-5);
  EXPECT_NEAR(saliency.at<float>(30, 80), 1 / (1 + std::exp(-blue)), 1e-5);
}

TEST_F(SaliencyNetworkTest, LogOddsBecomeProbabilities) {
  SaliencyNetwork network(
      Written({.weights = {3, 0, 0}, .is_logistic = false}));
  const cv::Mat saliency = network.Saliency(RedAndBlue());
  EXPECT_NEAR(saliency.at<float>(30, 20),
              1 / (1 + std::exp(-3 * (1 - 0.485) / 0.229)),
              1e-5);
}

TEST_F(SaliencyNetworkTest, UsesTheUsualSizeWhereTheFileHasNone) {
  SaliencyNetwork network(Written({.height = 0, .width = 0}));
  EXPECT_EQ(network.InputSize(), cv::Size(320, 320));
  EXPECT_NEAR(network.Saliency(RedAndBlue()).at<float>(1, 1), 0.5, 1e-6);
}

TEST_F(SaliencyNetworkTest, WrongNetworksAreNamed) {
  SaliencyNetwork two(Written({.num_outputs = 2}));
  EXPECT_THAT([&] { two.Saliency(RedAndBlue()); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("n.onnx"), HasSubstr("1 x 2 x 32 x 48"))));
  SaliencyNetwork endless(Written(
      {.bias = std::numeric_limits<float>::quiet_NaN(), .is_logistic = false}));
  EXPECT_THAT([&] { endless.Saliency(RedAndBlue()); },
              ThrowsMessage<InputError>(HasSubstr("not a number")));
  folder_.Write("junk.onnx", "this is no network");
  EXPECT_THAT([&] { SaliencyNetwork network(folder_ / "junk.onnx"); },
              ThrowsMessage<InputError>(HasSubstr("junk.onnx")));
  EXPECT_THAT([&] { SaliencyNetwork network(folder_ / "gone.onnx"); },
              ThrowsMessage<InputError>(HasSubstr("gone.onnx")));
}

TEST(OnnxInputSize, HasNoneInDamagedFiles) {
  const std::string bytes = OnnxWriter::Write({});
  ASSERT_EQ(OnnxInputSize(bytes), cv::Size(48, 32));
  // Every beginning of the file; the input is declared near its end.
  for (size_t length = 0; length < bytes.size() / 2; ++length) {
    EXPECT_EQ(OnnxInputSize(std::string_view(bytes).substr(0, length)),
              std::nullopt);
  }
  // Every byte changed: any answer will do, but no read beyond the end.
  for (size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = char(~changed[i]);
    OnnxInputSize(changed);
  }
}

}  // namespace
}  // namespace octacut
