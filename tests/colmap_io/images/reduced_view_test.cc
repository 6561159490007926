#include "colmap_io/images/reduced_view.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "colmap_io/images/view_window.h"
#include "colmap_io/model/camera_projector.h"

namespace octacut {
namespace {

SparseCamera Camera(double k1) {
  SparseCamera camera;
  camera.model_id = camera_model::kSimpleRadial;
  camera.width = 403;
  camera.height = 301;
  camera.params = {420, 200, 150, k1};
  return camera;
}

// A blurred disc in the photograph.
cv::Mat Disc(const SparseCamera& camera) {
  cv::Mat disc = cv::Mat::zeros(int(camera.height), int(camera.width), CV_8U);
  cv::circle(disc, {230, 120}, 60, cv::Scalar(255), cv::FILLED, cv::LINE_AA);
  cv::GaussianBlur(disc, disc, cv::Size(), 3);
  return disc;
}

TEST(ReducedView, ShowsAllOfThePhotograph) {
  for (const double k1 : {0.0, -0.2, 0.1}) {
    const SparseCamera camera = Camera(k1);
    const PinholeCamera reduced = ReducedCamera(camera, 200);
    EXPECT_EQ(std::max(reduced.width, reduced.height), 200);
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(0.5, 0.5),
                                          Eigen::Vector2d(402.5, 300.5),
                                          Eigen::Vector2d(402.5, 0.5)}) {
      const Eigen::Vector2d pixel =
          reduced.Project(*CameraProjector(camera).CamFromImg(corner));
      EXPECT_GE(pixel.x(), 0);
      EXPECT_GE(pixel.y(), 0);
      EXPECT_LE(pixel.x(), reduced.width);
      EXPECT_LE(pixel.y(), reduced.height);
    }
  }
}

TEST(ReducedView, ValuesComeBackWhereTheyWere) {
  for (const double k1 : {0.0, -0.2, 0.1}) {
    const SparseCamera camera = Camera(k1);
    const cv::Mat disc = Disc(camera);
    const PinholeCamera reduced = ReducedCamera(camera, 250);
    cv::Mat values;
    ReduceView(disc, camera, reduced).convertTo(values, CV_32F);
    const cv::Mat back = CarryBack(values, reduced, camera);
    ASSERT_EQ(back.size(), disc.size());
    cv::Mat expected;
    disc.convertTo(expected, CV_32F);
    // The steepest slope is 34 grey levels a pixel.
    EXPECT_LT(cv::norm(back, expected, cv::NORM_INF), 12) << k1;
    EXPECT_LT(cv::norm(back, expected, cv::NORM_L1) / double(disc.total()), 0.3)
        << k1;
  }
}

// At a quarter of the photograph's height from its middle the distortion turns
// back: pixels outside of that circle have no ray.
TEST(ReducedView, NothingComesBackWhereTheLensHasNoRays) {
  const SparseCamera camera = Camera(-2);
  const PinholeCamera reduced = ReducedCamera(camera, 250);
  const CameraProjector projector(camera);
  // Grows to the right, so that a value tells where it comes from.
  cv::Mat values(reduced.height, reduced.width, CV_32F);
  for (int x = 0; x < values.cols; ++x) {
    values.col(x).setTo(1 + x);
  }
  const cv::Mat back = CarryBack(values, reduced, camera);
  int num_without = 0;
  for (int y = 0; y < back.rows; ++y) {
    for (int x = 0; x < back.cols; ++x) {
      const auto ray = projector.CamFromImg({x + 0.5, y + 0.5});
      if (!ray) {
        ++num_without;
        ASSERT_EQ(back.at<float>(y, x), 0) << x << ", " << y;
      } else {
        const double place = reduced.Project(*ray).x() + 0.5;
        // Near its end the lens is far from linear between the places.
        ASSERT_NEAR(back.at<float>(y, x),
                    std::clamp(place, 1.0, double(values.cols)),
                    0.5)
            << x << ", " << y;
      }
    }
  }
  EXPECT_GT(num_without, back.rows * back.cols / 10);
}

TEST(ReducedView, SmallPhotographsKeepTheirSize) {
  const PinholeCamera reduced = ReducedCamera(Camera(0), 1000);
  EXPECT_EQ(reduced.width, 403);
  EXPECT_EQ(reduced.height, 301);
  EXPECT_NEAR(reduced.fx, 420, 1e-9);
  EXPECT_NEAR(reduced.cx, 200, 1e-9);
}

}  // namespace
}  // namespace octacut
