#include "colmap_io/images/view_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_io/images/reduce_mask.h"
#include "colmap_io/model/camera_projector.h"
#include "core/base/error.h"
#include "tests/colmap_io/images/test_workspace.h"
#include "tests/colmap_io/model/test_cameras.h"

namespace octacut {
namespace {

using testing::RingPose;
using testing::SphereMask;

const SparseCamera kWindowPinhole = {
    1, camera_model::kPinhole, 640, 480, {600, 610, 321.5, 238.25}};

Region RegionOfSphere(double radius) {
  Region region;
  region.box = {Eigen::Vector3d::Constant(-radius),
                Eigen::Vector3d::Constant(radius)};
  region.cube.edge = 2.16 * radius;
  region.cube.min_corner = Eigen::Vector3d::Constant(-1.08 * radius);
  return region;
}

TEST(ViewWindow, IsAWholePixelCropAtFullResolution) {
  const Region region = RegionOfSphere(0.4);
  const Rigid3d pose = RingPose(3, 12);
  const auto window = PlanWindow(kWindowPinhole,
                                 FrameOfCamera(kWindowPinhole),
                                 pose,
                                 region,
                                 9,
                                 WindowOptions());
  ASSERT_TRUE(window.has_value());
  EXPECT_EQ(window->fx, 600);
  EXPECT_EQ(window->fy, 610);
  const double x0 = 321.5 - window->cx;
  const double y0 = 238.25 - window->cy;
  EXPECT_EQ(x0, std::floor(x0));
  EXPECT_EQ(y0, std::floor(y0));
  EXPECT_GE(x0, 0);
  EXPECT_LE(x0 + window->width, 640);
  EXPECT_LT(window->width, 320);
  // All of the region with the margin.
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector2d pixel = window->Project(
        pose * region.box.corner(Eigen::AlignedBox3d::CornerType(corner)));
    EXPECT_GE(pixel.minCoeff(), 4);
    EXPECT_LE(pixel.x(), window->width - 4);
    EXPECT_LE(pixel.y(), window->height - 4);
  }
}

TEST(ViewWindow, IsReducedToWhatTheVoxelsNeed) {
  const Region region = RegionOfSphere(1);
  const Rigid3d pose = RingPose(3, 12);
  const Frame frame = FrameOfCamera(kWindowPinhole);
  size_t last = 0;
  for (int level = 4; level <= 10; ++level) {
    const auto window =
        PlanWindow(kWindowPinhole, frame, pose, region, level, WindowOptions());
    ASSERT_TRUE(window.has_value());
    EXPECT_LE(window->fx, 600);
    EXPECT_NEAR(window->fy / window->fx, 610.0 / 600.0, 1e-12);
    // A voxel at the farthest corner.
    double depth = 0;
    for (int corner = 0; corner < 8; ++corner) {
      depth = std::max(
          depth,
          (pose * region.box.corner(Eigen::AlignedBox3d::CornerType(corner)))
              .z());
    }
    const double pixels = window->fx * region.cube.VoxelSize(level) / depth;
    if (window->fx < 600) {
      EXPECT_NEAR(pixels, 1.5, 1e-9);
      EXPECT_LE(window->fx, 600 / 1.25);
    } else {
      EXPECT_LE(pixels, 1.5 * 1.25 + 1e-9);
    }
    const size_t bytes = SceneBytes({*window});
    EXPECT_EQ(bytes, size_t(window->width) * size_t(window->height) * 4);
    EXPECT_GE(bytes, last);
    last = bytes;
  }
}

TEST(ViewWindow, EndsAtTheFrame) {
  const Region region = RegionOfSphere(4.5);  // holds the camera
  const auto window = PlanWindow(kWindowPinhole,
                                 FrameOfCamera(kWindowPinhole),
                                 RingPose(0, 12),
                                 region,
                                 9,
                                 WindowOptions());
  ASSERT_TRUE(window.has_value());
  EXPECT_EQ(window->width, 640);
  EXPECT_EQ(window->height, 480);
  EXPECT_EQ(window->cx, 321.5);
}

TEST(ViewWindow, IsEmptyWhereTheRegionIsNotSeen) {
  Region region = RegionOfSphere(0.3);
  const Rigid3d pose = RingPose(0, 12);
  const auto at = [&](const Eigen::Vector3d& point_in_cam) {
    region.box.translate(pose.Inverse() * point_in_cam - region.box.center());
    return PlanWindow(kWindowPinhole,
                      FrameOfCamera(kWindowPinhole),
                      pose,
                      region,
                      9,
                      WindowOptions());
  };
  EXPECT_TRUE(at({0, 0, 4}).has_value());
  EXPECT_FALSE(at({0, 0, -4}).has_value());
  EXPECT_FALSE(at({9, 0, 4}).has_value());
  EXPECT_FALSE(at({0, -9, 4}).has_value());
}

TEST(ViewWindow, FramesHoldEveryPixelOfEveryModel) {
  for (const SparseCamera& camera : TestCameras()) {
    const CameraProjector projector(camera);
    const Frame frame = FrameOfCamera(camera);
    for (int y = 0; y <= 480; y += 20) {
      for (int x = 0; x <= 640; x += 20) {
        const auto ray = projector.CamFromImg({double(x), double(y)});
        if (!ray || !(ray->z() > 0)) {
          EXPECT_FALSE(frame.complete);
          continue;
        }
        const Eigen::Vector2d tangents(ray->x() / ray->z(),
                                       ray->y() / ray->z());
        if (tangents.cwiseAbs().maxCoeff() > kMaxTangent) {
          EXPECT_FALSE(frame.complete);
        } else {
          EXPECT_LE(frame.tangents.exteriorDistance(tangents), 1e-3)
              << "model " << camera.model_id;
        }
      }
    }
  }
}

TEST(WindowOptions, DefaultsAreValidAndBadValuesAreNamed) {
  EXPECT_NO_THROW(WindowOptions().Check());
  WindowOptions options;
  options.pixels_per_voxel = 0;
  EXPECT_THROW(options.Check(), OptionError);
  options = {};
  options.min_reduction = 0.5;
  EXPECT_THROW(options.Check(), OptionError);
  options = {};
  options.margin = -1;
  EXPECT_THROW(options.Check(), OptionError);
}

// One camera a model.
std::vector<SparseCamera> OneCameraAModel() {
  std::vector<SparseCamera> cameras;
  for (const SparseCamera& camera : TestCameras()) {
    if (cameras.empty() || cameras.back().model_id != camera.model_id) {
      cameras.push_back(camera);
    }
  }
  return cameras;
}

// No point of the object is lost, for every camera model, closed views and
// views that cut the object off.
TEST(ReduceMask, IsConservativeForEveryModel) {
  const Rigid3d pose = RingPose(5, 12);
  for (const SparseCamera& camera : OneCameraAModel()) {
    const CameraProjector projector(camera);
    for (const double radius : {0.7, 2.5}) {
      const cv::Mat mask = SphereMask(camera, pose, radius);
      const ReducedMask reduced =
          ReduceMask(mask, camera, FrameOfCamera(camera), 200);
      ASSERT_EQ(reduced.mask.cols, reduced.camera.width);
      ASSERT_EQ(reduced.mask.rows, reduced.camera.height);
      bool touches = false;
      for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
          if (mask.at<uint8_t>(y, x) == 0) {
            continue;
          }
          touches = touches || x == 0 || y == 0 || x == 639 || y == 479;
          // Inside, a lattice of pixels will do.
          if (cv::countNonZero(mask(cv::Rect(x - 1, y - 1, 3, 3) &
                                    cv::Rect(0, 0, 640, 480))) == 9 &&
              (x % 8 != 0 || y % 8 != 0)) {
            continue;
          }
          const auto ray = projector.CamFromImg({x + 0.5, y + 0.5});
          if (!ray || ray->z() <= 0) {
            continue;
          }
          const Eigen::Vector2d pixel = reduced.camera.Project(*ray);
          if (pixel.minCoeff() < 0 || pixel.x() >= reduced.camera.width ||
              pixel.y() >= reduced.camera.height) {
            EXPECT_TRUE(touches) << "model " << camera.model_id;
            continue;
          }
          ASSERT_EQ(reduced.mask.at<uint8_t>(int(pixel.y()), int(pixel.x())),
                    255)
              << "model " << camera.model_id << " at " << x << " " << y;
        }
      }
      cv::Mat border = reduced.mask.clone();
      border(cv::Rect(1, 1, border.cols - 2, border.rows - 2)) = 0;
      EXPECT_EQ(cv::countNonZero(border) > 0, touches)
          << "model " << camera.model_id << " radius " << radius;
    }
  }
}

// And little is added.
TEST(ReduceMask, IsTight) {
  const Rigid3d pose = RingPose(5, 12);
  for (const SparseCamera& camera : OneCameraAModel()) {
    const cv::Mat mask = SphereMask(camera, pose, 0.7);
    const ReducedMask reduced =
        ReduceMask(mask, camera, FrameOfCamera(camera), 320);
    // Rays that miss a sphere a little larger are background.
    for (int y = 0; y < reduced.mask.rows; ++y) {
      for (int x = 0; x < reduced.mask.cols; ++x) {
        const Eigen::Vector3d ray =
            reduced.camera.Unproject({x + 0.5, y + 0.5}).normalized();
        if (ray.cross(pose.translation).norm() > 0.7 + 5 * 4.0 / 300) {
          ASSERT_EQ(reduced.mask.at<uint8_t>(y, x), 0)
              << "model " << camera.model_id;
        }
      }
    }
  }
}

}  // namespace
}  // namespace octacut
