#include "core/hull/hull_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/extract/extract_surface.h"
#include "core/extract/position_vertices.h"
#include "core/mesh/audit.h"
#include "core/mesh/keep_components.h"
#include "tests/core/grid/codes_of.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

constexpr int kSurfaceLevel = 6;

struct HullMesh {
  IndexedMesh mesh;
  MeshAudit audit;
};

HullMesh MeshOfHull(const TestScene& test,
                    const Eigen::AlignedBox3f& box,
                    int level = kSurfaceLevel) {
  VisualHullOptions options;
  options.hull_level = level;
  const LabeledVoxels surface =
      ComputeHullSurface(test.views, box, options, Context(2));
  HullMesh result;
  result.mesh = PositionVertices(
      ExtractSurface(
          surface.voxels, surface.labels, test.region.cube, Context(2)),
      Context(2));
  // Small pieces that no view denies are part of a hull, too.
  result.mesh = KeepLargestComponents(std::move(result.mesh), 0.1).mesh;
  result.audit = AuditMesh(result.mesh, Context(1));
  return result;
}

// The visual hull of a sphere around the origin is the intersection of the
// cones that touch it: how far the point is outside, at worst.
double DistanceToSphereHull(const TestScene& test,
                            double radius,
                            const Eigen::Vector3d& point) {
  double distance = -1e9;
  for (const View& view : test.scene.views) {
    const Eigen::Vector3d eye = view.Center();
    const Eigen::Vector3d axis = -eye.normalized();
    const double along = (point - eye).dot(axis);
    const double across = (point - eye - along * axis).norm();
    const double half_angle = std::asin(radius / eye.norm());
    distance = std::max(
        distance, across * std::cos(half_angle) - along * std::sin(half_angle));
  }
  return distance;
}

TEST(HullSurface, OfASphereIsTheIntersectionOfItsCones) {
  const double radius = 0.8;
  const TestScene test = MakeTestScene("sphere");
  const HullMesh hull = MeshOfHull(test, TestScene::UnitBox());
  EXPECT_EQ(hull.audit.DescribeFailure(), "");
  EXPECT_EQ(hull.audit.num_components, 1u);
  EXPECT_EQ(hull.audit.genus, 0);

  const double voxel = test.VoxelSize(kSurfaceLevel);
  double sum = 0;
  for (const Eigen::Vector3d& position : hull.mesh.positions) {
    const double distance = DistanceToSphereHull(test, radius, position);
    EXPECT_LT(std::abs(distance), voxel);
    sum += distance;
  }
  EXPECT_LT(std::abs(sum) / double(hull.mesh.positions.size()), 0.15 * voxel);

  // Volume of the intersection of the cones on a fine lattice.
  size_t count = 0;
  constexpr int kSamples = 80;
  for (int i = 0; i < kSamples * kSamples * kSamples; ++i) {
    const Eigen::Array3i node(
        i % kSamples, i / kSamples % kSamples, i / kSamples / kSamples);
    const Eigen::Vector3d unit = (node.cast<double>() + 0.5) / kSamples;
    count += DistanceToSphereHull(
                 test, radius, testing::ToWorld(test.region.cube, unit)) <= 0;
  }
  const double volume =
      double(count) * std::pow(test.region.cube.edge / kSamples, 3);
  const double sphere = 4.0 / 3 * std::numbers::pi * std::pow(radius, 3);
  EXPECT_GT(volume, sphere);
  EXPECT_NEAR(hull.audit.volume, volume, 0.015 * volume);
}

TEST(HullSurface, OfATorusHasItsHole) {
  const TestScene test = MakeTestScene("torus");
  const HullMesh hull = MeshOfHull(test, TestScene::UnitBox());
  EXPECT_EQ(hull.audit.DescribeFailure(), "");
  EXPECT_EQ(hull.audit.num_components, 1u);
  EXPECT_EQ(hull.audit.genus, 1);
  const double torus =
      2 * std::pow(std::numbers::pi, 2) * 0.65 * std::pow(0.25, 2);
  EXPECT_GT(hull.audit.volume, torus);
  EXPECT_LT(hull.audit.volume, 1.35 * torus);
  for (const Eigen::Vector3d& position : hull.mesh.positions) {
    EXPECT_GT(test.synthetic.object.shape(position),
              -test.VoxelSize(kSurfaceLevel));
  }
}

TEST(HullSurface, IsClosedWhereTheBoxClipsIt) {
  const TestScene test = MakeTestScene("sphere");
  // Half of it; through the middle of voxels and along their faces.
  for (const float cut : {0.51f, 0.5f}) {
    const HullMesh hull =
        MeshOfHull(test,
                   Eigen::AlignedBox3f(Eigen::Vector3f::Zero(),
                                       Eigen::Vector3f(1, cut, 1)));
    EXPECT_EQ(hull.audit.DescribeFailure(), "") << cut;
    EXPECT_EQ(hull.audit.num_components, 1u);
    EXPECT_EQ(hull.audit.genus, 0);
    const double top =
        testing::ToUnit(test.region.cube, hull.audit.bounding_box.max()).y();
    EXPECT_NEAR(top, cut, 1.0 / (1 << kSurfaceLevel));
  }
}

TEST(HullSurface, OfViewsThatSeeNothingButObjectIsTheBox) {
  TestScene test = MakeTestScene("sphere", 80, 60, 6);
  for (View& view : test.scene.views) {
    view.mask.setTo(255);
  }
  test.views = PrepareViews(test.scene, test.region.cube, Context(1));
  for (const float low : {0.25f, 0.26f}) {
    const Eigen::AlignedBox3f box(Eigen::Vector3f(low, 0.25f, 0.3f),
                                  Eigen::Vector3f(0.75f, 0.8f, 0.75f));
    const HullMesh hull = MeshOfHull(test, box, 5);
    EXPECT_EQ(hull.audit.DescribeFailure(), "");
    EXPECT_EQ(hull.audit.genus, 0);
    const double expected = box.volume() * std::pow(test.region.cube.edge, 3);
    EXPECT_NEAR(hull.audit.volume, expected, 0.15 * expected);
  }
}

TEST(HullSurface, IsTheSameForAnyNumberOfThreads) {
  const TestScene test = MakeTestScene("fingers", 120, 90, 12);
  VisualHullOptions options;
  options.hull_level = 5;
  const LabeledVoxels expected =
      ComputeHullSurface(test.views, TestScene::UnitBox(), options, Context(1));
  EXPECT_GT(expected.voxels.Size(), 100u);
  for (const int num_threads : {2, 4}) {
    const LabeledVoxels surface = ComputeHullSurface(
        test.views, TestScene::UnitBox(), options, Context(num_threads));
    EXPECT_EQ(CodesOf(surface.voxels), CodesOf(expected.voxels));
    EXPECT_EQ(surface.labels, expected.labels);
  }
}

TEST(HullSurface, RefusesBadOptions) {
  VisualHullOptions options;
  options.hull_level = 1;
  EXPECT_THROW(
      ComputeHullSurface(ViewSet(), TestScene::UnitBox(), options, Context(1)),
      OptionError);
}

}  // namespace
}  // namespace octacut
