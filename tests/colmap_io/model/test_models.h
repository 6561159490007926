// Sparse models to read and write, and where the shared ones are.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <random>
#include <string>

#include "colmap_io/model/sparse_model.h"
#include "core/base/error.h"
#include "tests/colmap_io/files/temporary_folder.h"
#include "tests/colmap_io/model/test_cameras.h"
#include "tests/core/base/error_texts.h"

namespace octacut {

// A consistent model with awkward content: every camera model, ids out of
// order, names with folders, blanks and other alphabets, an image without
// observations, points without tracks, values that need all their digits.
inline SparseModel TestModel(uint32_t seed, int num_images, int num_points) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-10, 10);
  SparseModel model;
  model.cameras = TestCameras();
  for (int i = 0; i < num_points; ++i) {
    SparsePoint point;
    point.id = uint64_t(1000 - 3 * i) + (i == 0 ? 1ull << 40 : 0);
    point.xyz = {uniform(random), uniform(random), uniform(random) / 3e7};
    point.rgb = {uint8_t(random()), uint8_t(random()), uint8_t(random())};
    point.error = i % 3 == 0 ? -1 : std::abs(uniform(random));
    model.points.push_back(point);
  }
  for (int i = 0; i < num_images; ++i) {
    SparseImage image;
    image.id = uint32_t(7 + 5 * ((num_images - i) % num_images));
    image.camera_id = model.cameras[size_t(i) % model.cameras.size()].id;
    image.name = "folder " + std::to_string(i) + "/\u00fcber \u732b.jpg";
    image.rotation =
        Eigen::Quaterniond(
            uniform(random), uniform(random), uniform(random), uniform(random))
            .normalized();
    image.translation = {uniform(random), uniform(random), uniform(random)};
    for (int j = 0; i != 1 && j < 5; ++j) {
      SparseObservation observation{320 + 31 * uniform(random),
                                    240 + 23 * uniform(random)};
      if (num_points > 0 && j % 2 == 0) {
        SparsePoint& point = model.points[random() % model.points.size()];
        observation.point3D_id = point.id;
        point.track.push_back({image.id, uint32_t(j)});
      }
      image.observations.push_back(observation);
    }
    model.images.push_back(image);
  }
  return model;
}

inline bool SameBits(double a, double b) {
  return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

inline void ExpectSameCameras(const SparseModel& a, const SparseModel& b) {
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (size_t i = 0; i < a.cameras.size(); ++i) {
    EXPECT_EQ(a.cameras[i].id, b.cameras[i].id);
    EXPECT_EQ(a.cameras[i].model_id, b.cameras[i].model_id);
    EXPECT_EQ(a.cameras[i].width, b.cameras[i].width);
    EXPECT_EQ(a.cameras[i].height, b.cameras[i].height);
    EXPECT_EQ(a.cameras[i].params, b.cameras[i].params);
  }
}

// `pose_tolerance`: 0 demands the same bits of the rotation.
inline void ExpectSameImages(const SparseModel& a,
                             const SparseModel& b,
                             double rotation_tolerance) {
  ASSERT_EQ(a.images.size(), b.images.size());
  for (size_t i = 0; i < a.images.size(); ++i) {
    const SparseImage& x = a.images[i];
    const SparseImage& y = b.images[i];
    EXPECT_EQ(x.id, y.id);
    EXPECT_EQ(x.camera_id, y.camera_id);
    EXPECT_EQ(x.name, y.name);
    EXPECT_LE((x.rotation.coeffs() - y.rotation.coeffs()).norm(),
              rotation_tolerance);
    EXPECT_EQ(x.translation, y.translation);
    ASSERT_EQ(x.observations.size(), y.observations.size());
    for (size_t j = 0; j < x.observations.size(); ++j) {
      ASSERT_TRUE(SameBits(x.observations[j].x, y.observations[j].x));
      ASSERT_TRUE(SameBits(x.observations[j].y, y.observations[j].y));
      ASSERT_EQ(x.observations[j].point3D_id, y.observations[j].point3D_id);
    }
  }
}

inline void ExpectSamePoints(const SparseModel& a, const SparseModel& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (size_t i = 0; i < a.points.size(); ++i) {
    const SparsePoint& x = a.points[i];
    const SparsePoint& y = b.points[i];
    ASSERT_EQ(x.id, y.id);
    ASSERT_EQ(x.xyz, y.xyz);
    ASSERT_EQ(x.rgb, y.rgb);
    ASSERT_TRUE(SameBits(x.error, y.error));
    ASSERT_EQ(x.track.size(), y.track.size());
    for (size_t j = 0; j < x.track.size(); ++j) {
      ASSERT_EQ(x.track[j].image_id, y.track[j].image_id);
      ASSERT_EQ(x.track[j].point2D_index, y.track[j].point2D_index);
    }
  }
}

inline void ExpectSameModel(const SparseModel& a, const SparseModel& b) {
  ExpectSameCameras(a, b);
  ExpectSameImages(a, b, 0);
  ExpectSamePoints(a, b);
}

// A folder of its own for each test, removed at the end.
class ModelFolderTest : public ::testing::Test {
 private:
  const TemporaryFolder temporary_folder_;

 protected:
  const std::filesystem::path folder_ = temporary_folder_.Path();
};

// The shared measurement data, where it is there.
inline std::optional<std::filesystem::path> SharedData() {
  if (const char* path = std::getenv("OCTACUT_SHARED_DATA")) return path;
  const std::filesystem::path beside =
      std::filesystem::path(OCTACUT_SOURCE_DIR) / "../shared/data";
  if (std::filesystem::is_directory(beside)) return beside;
  return std::nullopt;
}

}  // namespace octacut
