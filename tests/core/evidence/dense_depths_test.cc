// Swept depth maps against the surface that the views show.
#include "core/evidence/dense_depths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/raycast/render.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"

namespace octacut {
namespace {

TEST(SweepDenseDepths, LieOnTheSurfaceAndOnTheObject) {
  const SyntheticScene synthetic =
      MakeScene(QuickScene("torus", 240, 180, 24), Context(2));
  const Scene scene = ToScene(synthetic);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : synthetic.reference.positions) {
    box.extend(p);
  }
  BoundingCube cube;
  cube.edge = 1.1 * box.sizes().maxCoeff();
  cube.min_corner = box.center() - Eigen::Vector3d::Constant(cube.edge / 2);
  DenseDepthsOptions options;
  options.level = 6;
  const std::vector<cv::Mat> depths =
      SweepDenseDepths(scene, cube, box, options, Context(2));
  ASSERT_EQ(depths.size(), scene.views.size());
  const RayScene rays(synthetic.reference);
  const double voxel = cube.VoxelSize(options.level);
  std::vector<double> errors;
  size_t num_object = 0;
  for (size_t i = 0; i < depths.size(); ++i) {
    const View& view = scene.views[i];
    ASSERT_EQ(depths[i].size(), view.mask.size());
    const cv::Mat truth =
        RenderDepth(rays, view.camera, view.cam_from_world, Context(2));
    for (int y = 0; y < truth.rows; ++y) {
      for (int x = 0; x < truth.cols; ++x) {
        const float depth = depths[i].at<float>(y, x);
        if (view.mask.at<uint8_t>(y, x) < kObjectThreshold) {
          EXPECT_EQ(depth, 0);
          continue;
        }
        ++num_object;
        if (depth > 0 && truth.at<float>(y, x) > 0) {
          errors.push_back(std::abs(depth - truth.at<float>(y, x)));
        }
      }
    }
  }
  // Depths on a good part of the object, half of them within half a voxel.
  ASSERT_GT(double(errors.size()), 0.3 * double(num_object));
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.5 * voxel);
  EXPECT_LT(errors[errors.size() * 9 / 10], 2 * voxel);
  // The same bytes for any number of threads.
  const std::vector<cv::Mat> again =
      SweepDenseDepths(scene, cube, box, options, Context(1));
  EXPECT_EQ(cv::countNonZero(again[0] != depths[0]), 0);
}

}  // namespace
}  // namespace octacut
