#include "core/benchmark/compare/seen_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/benchmark/compare/compare_meshes.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// On the x axis, looking at the origin, 60 degrees wide.
PosedCamera CameraOnXAxis(double x) {
  PosedCamera posed;
  posed.camera = {200, 200, 173.2, 173.2, 100, 100};
  const Eigen::Vector3d forward(x > 0 ? -1 : 1, 0, 0);
  const Eigen::Vector3d down(0, 0, -1);
  posed.cam_from_world.rotation.row(0) = down.cross(forward);
  posed.cam_from_world.rotation.row(1) = down;
  posed.cam_from_world.rotation.row(2) = forward;
  posed.cam_from_world.translation =
      -(posed.cam_from_world.rotation * Eigen::Vector3d(x, 0, 0));
  return posed;
}

SeenReferenceOptions Options(int min_views, double max_angle = 90) {
  SeenReferenceOptions options;
  options.min_views = min_views;
  options.max_angle = max_angle;
  return options;
}

// What counts of a mesh's triangles, judged at their centres.
std::vector<bool> Counting(const IndexedMesh& mesh,
                           const ReferenceFilter& filter) {
  std::vector<bool> counting;
  for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    counting.push_back(filter(
        i,
        (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) /
            3));
  }
  return counting;
}

Eigen::Vector3d Normal(const IndexedMesh& mesh, size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return (mesh.positions[t[1]] - mesh.positions[t[0]])
      .cross(mesh.positions[t[2]] - mesh.positions[t[0]])
      .normalized();
}

TEST(SeenByCameras, SeesTheSideThatFacesIt) {
  const IndexedMesh sphere = Sphere(40, 1.0);
  const std::vector<bool> counting =
      Counting(sphere, SeenByCameras(sphere, {CameraOnXAxis(100)}, Options(1)));
  // So far away the frame does not matter and the rays are nearly parallel.
  size_t num_counting = 0;
  for (size_t i = 0; i < counting.size(); ++i) {
    const double toward = Normal(sphere, i).x();
    if (toward > 0.05) {
      EXPECT_TRUE(counting[i]) << i;
    } else if (toward < -0.01) {
      EXPECT_FALSE(counting[i]) << i;
    }
    num_counting += counting[i];
  }
  EXPECT_GT(num_counting, counting.size() / 3);
}

TEST(SeenByCameras, NeedsAsManyViewsAsAskedFor) {
  const IndexedMesh sphere = Sphere(40, 1.0);
  const std::vector<PosedCamera> both = {CameraOnXAxis(4), CameraOnXAxis(-4)};
  const std::vector<bool> once =
      Counting(sphere, SeenByCameras(sphere, both, Options(1)));
  const std::vector<bool> twice =
      Counting(sphere, SeenByCameras(sphere, both, Options(2)));
  EXPECT_GT(std::count(once.begin(), once.end(), true), 100);
  EXPECT_EQ(std::count(twice.begin(), twice.end(), true), 0);
}

TEST(SeenByCameras, AngleLimits) {
  const IndexedMesh sphere = Sphere(40, 1.0);
  const std::vector<bool> counting = Counting(
      sphere, SeenByCameras(sphere, {CameraOnXAxis(100)}, Options(1, 60)));
  for (size_t i = 0; i < counting.size(); ++i) {
    const double cosine = Normal(sphere, i).x();
    if (std::abs(cosine - 0.5) > 0.02) {
      EXPECT_EQ(counting[i], cosine > 0.5) << i;
    }
  }
}

TEST(SeenByCameras, HiddenAndOutOfFrameDoNotCount) {
  // A small sphere behind a large one, and one far aside.
  const IndexedMesh large = Sphere(40, 1.0);
  const size_t num_large = large.triangles.size();
  const IndexedMesh small = Sphere(12, 0.3);
  const IndexedMesh mesh =
      Joined(Joined(large, Moved(small, {-3, 0, 0})), Moved(small, {0, 40, 0}));
  const std::vector<bool> counting =
      Counting(mesh, SeenByCameras(mesh, {CameraOnXAxis(5)}, Options(1)));
  EXPECT_GT(std::count(counting.begin(), counting.begin() + num_large, true),
            100);
  EXPECT_EQ(std::count(counting.begin() + num_large, counting.end(), true), 0);
}

TEST(SeenByCameras, ErrorsOfTheUnseenSideAreNotCounted) {
  const IndexedMesh reference = Sphere(40, 1.0);
  IndexedMesh dented = reference;
  for (Eigen::Vector3d& p : dented.positions) {
    p *= p.x() < -0.3 ? 0.9 : 1;
  }
  CompareMeshesOptions options;
  options.num_samples = 20000;
  options.reference_filter =
      SeenByCameras(reference, {CameraOnXAxis(100)}, Options(1));
  EXPECT_LT(
      CompareMeshes(dented, reference, options, Context(2)).to_reference.max,
      1e-9);
  options.reference_filter = nullptr;
  EXPECT_GT(
      CompareMeshes(dented, reference, options, Context(2)).to_reference.max,
      0.05);
}

TEST(SeenByCameras, RefusesTooFewCamerasAndBadOptions) {
  const IndexedMesh sphere = Sphere(8, 1.0);
  EXPECT_THAT([&] { SeenByCameras(sphere, {CameraOnXAxis(5)}, Options(2)); },
              ThrowsMessage<InputError>(HasSubstr("min_views = 2")));
  EXPECT_THROW(Options(0).Check(), OptionError);
  EXPECT_THROW(Options(1, 0).Check(), OptionError);
  EXPECT_THROW(Options(1, 91).Check(), OptionError);
}

}  // namespace
}  // namespace octacut
