#include "colmap_io/images/undistort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/camera_projector.h"
#include "tests/colmap_io/images/test_workspace.h"
#include "tests/colmap_io/model/test_cameras.h"

namespace octacut {
namespace {

using testing::Texture;
using testing::TextureAt;

const SparseCamera kPinhole = {
    1, camera_model::kPinhole, 400, 300, {420, 430, 198.3, 151.2}};

TEST(Undistort, CopiesAWindowOfAPinholeExactly) {
  const cv::Mat source = Texture(400, 300);
  const PinholeCamera window = {120, 90, 420, 430, 198.3 - 37, 151.2 - 101};
  const cv::Mat result = Undistort(source, kPinhole, window, 0, Context(2));
  const cv::Mat expected = source(cv::Rect(37, 101, 120, 90));
  EXPECT_EQ(cv::norm(result, expected, cv::NORM_INF), 0);
}

TEST(Undistort, FillsWhatTheSourceDoesNotCover) {
  const cv::Mat mask(300, 400, CV_8UC1, cv::Scalar(7));
  const PinholeCamera window = {100, 80, 420, 430, 198.3 + 10, 151.2 + 20};
  const cv::Mat result = Undistort(mask, kPinhole, window, 255, Context(1));
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 100; ++x) {
      EXPECT_EQ(result.at<uint8_t>(y, x), x < 10 || y < 20 ? 255 : 7);
    }
  }
}

TEST(Undistort, AveragesWhatItReduces) {
  // The finest checkerboard: bilinear samples alone would give 0 or 255.
  cv::Mat checkers(300, 400, CV_8UC1);
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) {
      checkers.at<uint8_t>(y, x) = (x + y) % 2 ? 255 : 0;
    }
  }
  const PinholeCamera quarter = {100, 75, 105, 107.5, 198.3 / 4, 151.2 / 4};
  const cv::Mat result = Undistort(checkers, kPinhole, quarter, 0, Context(1));
  double low = 0;
  double high = 0;
  cv::minMaxLoc(result, &low, &high);
  EXPECT_GE(low, 127);
  EXPECT_LE(high, 128);
}

TEST(Undistort, ReducesByWholeFactorsAsTheMeanOfBlocks) {
  const cv::Mat source = Texture(400, 300);
  const PinholeCamera target = {100, 75, 105, 107.5, 198.3 / 4, 151.2 / 4};
  const cv::Mat result = Undistort(source, kPinhole, target, 0, Context(2));
  for (int y = 0; y < 75; ++y) {
    for (int x = 0; x < 100; ++x) {
      const cv::Scalar mean = cv::mean(source(cv::Rect(4 * x, 4 * y, 4, 4)));
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(result.at<cv::Vec3b>(y, x)[c], mean[c], 1.01);
      }
    }
  }
}

// Every model, at its own and at half resolution, against the texture's
// formula at the pixel that the model's projection says.
TEST(Undistort, FollowsTheProjectionOfEveryModel) {
  const cv::Mat source = Texture(640, 480);
  for (const SparseCamera& camera : TestCameras()) {
    const CameraProjector projector(camera);
    for (const double scale : {1.0, 0.5, 0.21}) {
      const PinholeCamera target = {int(200 * scale),
                                    int(160 * scale),
                                    scale * projector.Intrinsics().fx,
                                    scale * projector.Intrinsics().fy,
                                    scale * 90.2,
                                    scale * 75.6};
      const cv::Mat result = Undistort(source, camera, target, 0, Context(2));
      for (int y = 0; y < target.height; y += 7) {
        for (int x = 0; x < target.width; x += 7) {
          const auto pixel =
              projector.ImgFromCam(target.Unproject({x + 0.5, y + 0.5}));
          if (!pixel || pixel->minCoeff() < 3 || pixel->x() > 637 ||
              pixel->y() > 477) {
            continue;
          }
          const cv::Vec3d expected = TextureAt(pixel->x(), pixel->y());
          for (int c = 0; c < 3; ++c) {
            ASSERT_NEAR(result.at<cv::Vec3b>(y, x)[c], expected[c], 2.5)
                << "model " << camera.model_id << " scale " << scale << " at "
                << x << " " << y;
          }
        }
      }
    }
  }
}

TEST(Undistort, IsTheSameForAnyNumberOfThreads) {
  const cv::Mat source = Texture(640, 480);
  const SparseCamera camera = {
      1, camera_model::kOpenCV, 640, 480, {500, 505, 318, 243, -.2, .05, 0, 0}};
  const PinholeCamera target = {311, 207, 240, 241, 150, 100};
  const cv::Mat one = Undistort(source, camera, target, 0, Context(1));
  const cv::Mat four = Undistort(source, camera, target, 0, Context(4));
  EXPECT_EQ(cv::norm(one, four, cv::NORM_INF), 0);
}

TEST(Undistort, RefusesASourceOfAnotherSize) {
  EXPECT_THROW(
      Undistort(Texture(40, 30), kPinhole, {4, 4, 1, 1, 0, 0}, 0, Context(1)),
      InvariantError);
}

TEST(FindUncovered, BeyondTheFrameOfAPinholeToo) {
  const cv::Mat mask(300, 400, CV_8UC1, cv::Scalar(0));
  const PinholeCamera same = UndistortedCamera(kPinhole);
  const auto uncovered = [&](const PinholeCamera& target) {
    return FindUncovered(mask,
                         kPinhole,
                         target,
                         Undistort(mask, kPinhole, target, 255, Context(1)),
                         Context(1));
  };
  EXPECT_TRUE(uncovered(same).empty());
  PinholeCamera wider = same;
  wider.width += 20;
  const cv::Mat beyond = uncovered(wider);
  ASSERT_EQ(beyond.size(), cv::Size(420, 300));
  EXPECT_EQ(cv::countNonZero(beyond.colRange(0, 400)), 0);
  EXPECT_EQ(cv::countNonZero(beyond), 20 * 300);
}

TEST(UndistortedCamera, KeepsAPinhole) {
  const PinholeCamera camera = UndistortedCamera(kPinhole);
  EXPECT_EQ(camera.width, 400);
  EXPECT_EQ(camera.height, 300);
  EXPECT_EQ(camera.fy, 430);
  EXPECT_EQ(camera.cx, 198.3);
}

TEST(UndistortedCamera, LeavesNoPixelBlank) {
  for (const SparseCamera& camera : TestCameras()) {
    // Beyond 90 degrees there is no such camera; COLMAP's formula does not
    // care.
    const auto corner = CameraProjector(camera).CamFromImg({0.5, 0.5});
    if (!corner || corner->z() < 0.3 || IsUndistorted(camera)) {
      continue;
    }
    const PinholeCamera target = UndistortedCamera(camera);
    const cv::Mat white(480, 640, CV_8UC1, cv::Scalar(200));
    const cv::Mat result = Undistort(white, camera, target, 0, Context(2));
    const double blank =
        1 - double(cv::countNonZero(result)) / double(result.total());
    EXPECT_LE(blank, 0.012) << "model " << camera.model_id;
  }
}

}  // namespace
}  // namespace octacut
