#include "core/raycast/render.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <opencv2/core.hpp>

#include "tests/core/raycast/random_mesh.h"

namespace octacut {
namespace {

// A square of edge `size` in the plane z, seen from the camera at the origin.
IndexedMesh Square(double size, double z) {
  IndexedMesh mesh;
  const double h = size / 2;
  mesh.positions = {{-h, -h, z}, {-h, h, z}, {h, h, z}, {h, -h, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

PinholeCamera TestCamera() { return {64, 48, 60, 60, 32, 24}; }

TEST(RenderDepth, IsTheDistanceAlongTheViewingAxis) {
  Rigid3d cam_from_world;
  cam_from_world.translation = {0, 0, 1.5};
  const RayScene rays(Square(2, 4));
  const cv::Mat depth =
      RenderDepth(rays, TestCamera(), cam_from_world, Context(2));
  ASSERT_EQ(depth.type(), CV_32FC1);
  EXPECT_FLOAT_EQ(depth.at<float>(24, 32), 5.5f);
  EXPECT_FLOAT_EQ(depth.at<float>(20, 24), 5.5f);
  EXPECT_EQ(depth.at<float>(2, 2), 0);
}

TEST(RenderShaded, IsWhiteWhereNothingIs) {
  const IndexedMesh mesh = Square(2, 4);
  const cv::Mat image =
      RenderShaded(mesh, RayScene(mesh), TestCamera(), {}, {}, Context(2));
  const cv::Vec3b white(255, 255, 255);
  EXPECT_EQ(image.at<cv::Vec3b>(1, 1), white);
  EXPECT_NE(image.at<cv::Vec3b>(24, 32), white);
}

TEST(RenderShaded, PaintsVertexColors) {
  IndexedMesh mesh = Square(2, 4);
  mesh.colors.assign(4, {200, 0, 0});
  RenderOptions options;
  options.use_vertex_colors = true;
  const cv::Mat image =
      RenderShaded(mesh, RayScene(mesh), TestCamera(), {}, options, Context(2));
  const cv::Vec3b& pixel = image.at<cv::Vec3b>(24, 32);
  EXPECT_GT(pixel[2], 100);
  EXPECT_EQ(pixel[1], 0);
}

TEST(RenderShaded, HollowsAndShadowsAreDarker) {
  // A small square floats before a large one, toward the light.
  IndexedMesh mesh = Square(4, 4);
  const IndexedMesh front = Square(0.8, 3.6);
  for (const auto& triangle : front.triangles) {
    mesh.triangles.push_back(
        {triangle[0] + 4, triangle[1] + 4, triangle[2] + 4});
  }
  mesh.positions.insert(
      mesh.positions.end(), front.positions.begin(), front.positions.end());
  const cv::Mat image =
      RenderShaded(mesh, RayScene(mesh), TestCamera(), {}, {}, Context(2));
  const auto brightness = [&](int x, int y) {
    return cv::mean(image(cv::Rect(x, y, 3, 3)))[1];
  };
  // The light comes from the upper left: the shadow falls to the lower right.
  // On the other side, the small square hides as much of the sky.
  const double shadow = brightness(40, 32);
  const double hollow = brightness(21, 13);
  const double open = brightness(14, 8);
  EXPECT_LT(shadow, hollow - 20);
  EXPECT_LT(hollow, open);
}

TEST(RenderShaded, GivesTheSameBytesForAnyNumberOfThreads) {
  std::mt19937 rng(3);
  const IndexedMesh mesh = RandomSoup(rng, 100, {0, 0, 4}, 1, 0.5);
  const RayScene rays(mesh);
  const cv::Mat one =
      RenderShaded(mesh, rays, TestCamera(), {}, {}, Context(1));
  for (const int num_threads : {2, 4}) {
    const cv::Mat many =
        RenderShaded(mesh, rays, TestCamera(), {}, {}, Context(num_threads));
    EXPECT_EQ(std::memcmp(one.data, many.data, one.total() * 3), 0);
  }
}

}  // namespace
}  // namespace octacut
