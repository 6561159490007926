// Pictures, models and folders for the tests of this folder.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "colmap_io/model/camera_projector.h"
#include "colmap_io/model/sparse_model.h"
#include "core/base/error.h"
#include "tests/colmap_io/files/temporary_folder.h"
#include "tests/core/base/error_texts.h"
#include "tests/core/base/recorder.h"

namespace octacut::testing {

// A folder of its own for each test, removed at the end.
class FolderTest : public ::testing::Test {
 private:
  const TemporaryFolder temporary_folder_;

 protected:
  const std::filesystem::path folder_ = temporary_folder_.Path();
};

inline void WriteText(const std::filesystem::path& path,
                      const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

inline void WritePicture(const std::filesystem::path& path,
                         const cv::Mat& picture) {
  std::filesystem::create_directories(path.parent_path());
  ASSERT_TRUE(cv::imwrite(path.string(), picture)) << path;
}

// A smooth coloured texture at pixel coordinates.
inline cv::Vec3d TextureAt(double x, double y) {
  return {128 + 60 * std::sin(x / 19) + 50 * std::cos(y / 23),
          128 + 90 * std::sin((x + y) / 31),
          128 + 80 * std::cos((x - 2 * y) / 37)};
}

inline cv::Mat Texture(int width, int height) {
  cv::Mat picture(height, width, CV_8UC3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const cv::Vec3d colour = TextureAt(x + 0.5, y + 0.5);
      for (int c = 0; c < 3; ++c) {
        picture.at<cv::Vec3b>(y, x)[c] = uint8_t(std::lround(colour[c]));
      }
    }
  }
  return picture;
}

// Cameras on a ring of radius 4 about the origin that look at it.
inline Rigid3d RingPose(int i, int count) {
  const double azimuth = 2 * M_PI * i / count;
  const double elevation = (i % 2 ? 0.5 : -0.4);
  const Eigen::Vector3d center =
      4 * Eigen::Vector3d(std::cos(azimuth) * std::cos(elevation),
                          std::sin(azimuth) * std::cos(elevation),
                          std::sin(elevation));
  const Eigen::Vector3d z = -center.normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  Rigid3d pose;
  pose.rotation.row(0) = x;
  pose.rotation.row(1) = z.cross(x);
  pose.rotation.row(2) = z;
  pose.translation = -(pose.rotation * center);
  return pose;
}

// `count` images "i.png" on the ring, all by one camera.
inline SparseModel RingModel(const SparseCamera& camera, int count) {
  SparseModel model;
  model.cameras = {camera};
  model.cameras[0].id = 1;
  for (int i = 0; i < count; ++i) {
    SparseImage image;
    image.id = uint32_t(i + 1);
    image.camera_id = 1;
    image.name = std::to_string(i) + ".png";
    const Rigid3d pose = RingPose(i, count);
    image.rotation = Eigen::Quaterniond(pose.rotation).normalized();
    image.translation = pose.translation;
    model.images.push_back(image);
  }
  return model;
}

// Mask of a sphere of that radius about the origin: 255 where the ray of the
// pixel's centre meets it.
inline cv::Mat SphereMask(const SparseCamera& camera,
                          const Rigid3d& cam_from_world,
                          double radius) {
  const CameraProjector projector(camera);
  cv::Mat mask(int(camera.height), int(camera.width), CV_8UC1);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const auto ray = projector.CamFromImg({x + 0.5, y + 0.5});
      const Eigen::Vector3d& middle = cam_from_world.translation;
      mask.at<uint8_t>(y, x) =
          ray && ray->dot(middle) > 0 && ray->cross(middle).norm() <= radius
              ? 255
              : 0;
    }
  }
  return mask;
}

}  // namespace octacut::testing
