#include "core/raycast/depth_normals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

// A field z = 0.5 x over [0, 1]^2, seen from below along +z, 4 units away.
struct TiltedField {
  IndexedMesh mesh = HeightField(4, [](double x, double) { return 0.5 * x; });
  PinholeCamera camera{40, 40, 100, 100, 20, 20};
  Rigid3d cam_from_world{Eigen::Matrix3d::Identity(),
                         Eigen::Vector3d(-0.5, -0.5, 4)};
};

TEST(RenderDepthAndNormals, OfATiltedField) {
  const TiltedField field;
  const DepthAndNormals maps = RenderDepthAndNormals(field.mesh,
                                                     RayScene(field.mesh),
                                                     field.camera,
                                                     field.cam_from_world,
                                                     Context(2));
  // The ray of the middle pixel (20.5, 20.5) is (0.005, 0.005, 1); on the
  // field z = 4 + 0.5 (x + 0.5).
  EXPECT_NEAR(maps.depth.at<float>(20, 20), 4.25 / (1 - 0.5 * 0.005), 1e-5);
  const cv::Vec3f normal = maps.normals.at<cv::Vec3f>(20, 20);
  EXPECT_NEAR(normal[0], 0.5 / std::sqrt(1.25), 1e-6);
  EXPECT_NEAR(normal[1], 0, 1e-6);
  EXPECT_NEAR(normal[2], -1 / std::sqrt(1.25), 1e-6);
  EXPECT_EQ(maps.depth.at<float>(0, 0), 0);
  EXPECT_EQ(maps.normals.at<cv::Vec3f>(0, 0), cv::Vec3f(0, 0, 0));
}

TEST(FitNormals, AgreeWithTheSurface) {
  const TiltedField field;
  const DepthAndNormals rendered = RenderDepthAndNormals(field.mesh,
                                                         RayScene(field.mesh),
                                                         field.camera,
                                                         field.cam_from_world,
                                                         Context(2));
  const DepthAndNormals fitted =
      FitNormals(rendered.depth, field.camera, 2, Context(2));
  for (int y = 12; y < 28; ++y) {
    for (int x = 12; x < 28; ++x) {
      EXPECT_LT(cv::norm(fitted.normals.at<cv::Vec3f>(y, x) -
                         rendered.normals.at<cv::Vec3f>(y, x)),
                1e-3);
    }
  }
}

TEST(FitNormals, DropWhatHasNoPlane) {
  cv::Mat depth = cv::Mat::zeros(20, 20, CV_32FC1);
  depth.at<float>(5, 5) = 2;
  const PinholeCamera camera{20, 20, 30, 30, 10, 10};
  const DepthAndNormals fitted = FitNormals(depth, camera, 3, Context(2));
  EXPECT_EQ(fitted.depth.at<float>(5, 5), 0);
}

}  // namespace
}  // namespace octacut
