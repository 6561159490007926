#include "core/benchmark/compare/shared_cameras.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"

namespace octacut {
namespace {

Similarity3d ReferenceFromModel() {
  return {2.5,
          Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized())
              .toRotationMatrix(),
          Eigen::Vector3d(3, -4, 5)};
}

// A camera at `center` in the model's frame, with some rotation.
SharedCamera CameraAt(const Eigen::Vector3d& center, double angle) {
  const Similarity3d reference_from_model = ReferenceFromModel();
  SharedCamera camera;
  camera.cam_from_model.rotation =
      Eigen::AngleAxisd(angle, Eigen::Vector3d(0.2, 1, 0.1).normalized())
          .toRotationMatrix();
  camera.cam_from_model.translation =
      -(camera.cam_from_model.rotation * center);
  camera.cam_from_reference.rotation =
      camera.cam_from_model.rotation *
      reference_from_model.rotation.transpose();
  camera.cam_from_reference.translation =
      -(camera.cam_from_reference.rotation * (reference_from_model * center));
  return camera;
}

std::vector<SharedCamera> Ring(int count) {
  std::vector<SharedCamera> cameras;
  cameras.reserve(count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    cameras.push_back(CameraAt(
        {std::cos(angle), std::sin(angle), 0.1 * std::sin(3 * angle)}, angle));
  }
  return cameras;
}

void ExpectSame(const Similarity3d& actual, const Similarity3d& expected) {
  EXPECT_NEAR(actual.scale, expected.scale, 1e-9);
  EXPECT_LT((actual.rotation - expected.rotation).norm(), 1e-9);
  EXPECT_LT((actual.translation - expected.translation).norm(), 1e-9);
}

TEST(AlignSharedCameras, FindsTheSimilarity) {
  const SharedCameraAlignment alignment = AlignSharedCameras(Ring(9));
  ExpectSame(alignment.reference_from_model, ReferenceFromModel());
  EXPECT_LT(alignment.rms, 1e-9);
  // A ring of radius 1 that rises and falls by 0.1, 2.5 times as large.
  EXPECT_NEAR(alignment.spread, 2.5 * std::sqrt(1 + 0.005), 0.01);
}

TEST(AlignSharedCameras, ServesForCamerasOnALine) {
  std::vector<SharedCamera> cameras;
  cameras.reserve(4);
  for (int i = 0; i < 4; ++i) {
    cameras.push_back(CameraAt({double(i), 0, 1}, 0.1 * i));
  }
  ExpectSame(AlignSharedCameras(cameras).reference_from_model,
             ReferenceFromModel());
}

TEST(AlignSharedCameras, LeavesOutCamerasThatAreElsewhere) {
  std::vector<SharedCamera> cameras = Ring(12);
  // Some noise, so that the median is not zero.
  for (size_t i = 0; i < cameras.size(); ++i) {
    cameras[i].cam_from_reference.translation.x() +=
        1e-4 * std::sin(5.0 * double(i));
  }
  cameras[3].cam_from_reference.translation += Eigen::Vector3d(2, 1, 0);
  const SharedCameraAlignment alignment = AlignSharedCameras(cameras);
  EXPECT_LE(alignment.num_inliers, 11u);
  EXPECT_GE(alignment.num_inliers, 9u);
  EXPECT_LT(alignment.rms, 1e-3);
  EXPECT_NEAR(alignment.reference_from_model.scale, 2.5, 1e-3);
}

TEST(AlignSharedCameras, RefusesTooFewAndCoincidentCameras) {
  EXPECT_THROW(AlignSharedCameras(Ring(2)), InputError);
  std::vector<SharedCamera> same(5, CameraAt({1, 2, 3}, 0.3));
  EXPECT_THROW(AlignSharedCameras(same), InputError);
}

}  // namespace
}  // namespace octacut
