// End to end: what is hard for a minimal cut is still there in the mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/hash.h"
#include "tests/core/pipeline/reconstruction_checks.h"
#include "tests/core/views/render_once.h"

namespace octacut {
namespace {

using testing::InsideTest;
using testing::MeanDistance;
using testing::PipelineSpec;
using testing::QuickOptions;
using testing::ReconstructedScene;
using testing::ReconstructScene;
using testing::RenderOnce;

constexpr double kPi = std::numbers::pi;

// Closed, manifold, oriented outward, and as near to the reference as half a
// voxel in the mean, both ways.
void ExpectNearReference(const ReconstructedScene& scene) {
  const IndexedMesh& mesh = scene.mesh;
  EXPECT_EQ(scene.result.audit.DescribeFailure(), "");
  EXPECT_EQ(AuditMesh(mesh, Context(1)).DescribeFailure(), "");
  const IndexedMesh& reference = scene.synthetic.reference;
  EXPECT_LT(MeanDistance(mesh, reference), 0.5 * scene.VoxelSize());
  EXPECT_LT(MeanDistance(reference, mesh), 0.5 * scene.VoxelSize());
}

TEST(Reconstruct, Sphere) {
  const ReconstructedScene scene =
      ReconstructScene(PipelineSpec("sphere"), QuickOptions());
  ExpectNearReference(scene);
  const MeshAudit& audit = scene.result.audit;
  EXPECT_EQ(audit.num_components, 1u);
  EXPECT_EQ(audit.genus, 0);
  const double volume = 4.0 / 3 * kPi * std::pow(0.8, 3);
  const double area = 4 * kPi * std::pow(0.8, 2);
  EXPECT_NEAR(audit.volume, volume, 0.02 * volume);
  EXPECT_NEAR(audit.area, area, 0.03 * area);
}

SyntheticScene LumpWithMasks(const DegradeOptions& degrade) {
  SyntheticScene lump = RenderOnce(std::string("lump"), [](const auto& object) {
    return PipelineSpec(object, 240, 180);
  });
  for (size_t i = 0; i < lump.views.size(); ++i) {
    DegradeMask(degrade, HashBits(lump.spec.seed, i), lump.views[i].mask);
  }
  return lump;
}

// Two levels.
ReconstructionOptions CutOptions(int target_level) {
  ReconstructionOptions options;
  options.hull.hull_level = target_level - 1;
  options.target_level = target_level;
  options.refine = false;
  return options;
}

// Mean distance from the reference, in voxels.
double Error(const ReconstructedScene& scene) {
  return MeanDistance(scene.synthetic.reference, scene.mesh) /
         scene.VoxelSize();
}

// The same of a lump whose masks are too large by so many pixels.
double ErrorWithMasksOff(int mask_offset,
                         const ReconstructionOptions& options) {
  DegradeOptions degrade;
  degrade.mask_offset = mask_offset;
  return Error(ReconstructScene(LumpWithMasks(degrade), options));
}

TEST(Reconstruct, ToleratesMasksThatAreTooSmall) {
  ReconstructionOptions options = CutOptions(6);
  const double clean = ErrorWithMasksOff(0, options);
  options.masks.move_mask_borders = false;
  const double tolerant = ErrorWithMasksOff(-2, options);
  options.masks.mask_tolerance = 0;
  const double strict = ErrorWithMasksOff(-2, options);
  EXPECT_LT(tolerant, 1.5 * clean);
  EXPECT_GT(strict, 2 * clean);
  // The edges of the photographs show that all masks are too small.
  options.masks.move_mask_borders = true;
  EXPECT_LT(ErrorWithMasksOff(-2, options), 1.5 * clean);
}

TEST(Reconstruct, RefinesBeyondMasksThatAreOff) {
  const double clean = ErrorWithMasksOff(0, QuickOptions());
  EXPECT_LT(clean, 0.1);
  EXPECT_LT(ErrorWithMasksOff(-2, QuickOptions()), 1.2 * clean);
  EXPECT_LT(ErrorWithMasksOff(2, QuickOptions()), 1.2 * clean);
}

TEST(Reconstruct, ToleratesLargeHolesInMasks) {
  ReconstructionOptions options = CutOptions(7);
  const ReconstructedScene clean = ReconstructScene(LumpWithMasks({}), options);
  DegradeOptions degrade;
  degrade.num_mask_holes = 4;
  degrade.mask_defect_radius = 5;
  const ReconstructedScene filled =
      ReconstructScene(LumpWithMasks(degrade), options);
  EXPECT_GT(filled.result.summary.num_false_gaps, 48u);
  EXPECT_EQ(filled.result.audit.genus, 0);
  options.masks.fill_false_gaps = false;
  const ReconstructedScene unrepaired =
      ReconstructScene(LumpWithMasks(degrade), options);
  EXPECT_EQ(unrepaired.result.summary.num_false_gaps, 0u);
  EXPECT_GT(unrepaired.result.audit.genus, 3);
  const auto error = [](const ReconstructedScene& scene) {
    return MeanDistance(scene.mesh, scene.synthetic.reference) /
           scene.VoxelSize();
  };
  // Bites that stay take up to three times what little error there is.
  EXPECT_LT(error(filled), 3 * error(clean));
  EXPECT_LT(error(filled), 0.4);
  EXPECT_GT(error(unrepaired), 2 * error(filled));
}

TEST(Reconstruct, Torus) {
  const ReconstructedScene scene =
      ReconstructScene(PipelineSpec("torus"), QuickOptions());
  ExpectNearReference(scene);
  const MeshAudit& audit = scene.result.audit;
  EXPECT_EQ(audit.num_components, 1u);
  EXPECT_EQ(audit.genus, 1);
  const double volume = 2 * kPi * kPi * 0.65 * std::pow(0.25, 2);
  const double area = 4 * kPi * kPi * 0.65 * 0.25;
  EXPECT_NEAR(audit.volume, volume, 0.05 * volume);
  EXPECT_NEAR(audit.area, area, 0.04 * area);
}

// The cavity is a cylinder of radius 0.5 and depth 1 from z = 0.575 down; the
// wall 0.15 thick. Its hull is solid.
TEST(Reconstruct, ACupAsDeepAsWideIsHollow) {
  SceneSpec spec = PipelineSpec("cup");
  spec.rig.num_views = 14;
  spec.rig.min_elevation = -10;
  spec.rig.max_elevation = 30;
  SyntheticScene cup = MakeScene(spec, Context(2));
  // The bottom is in sight from 45 degrees on, half of it from 63.
  spec.rig.num_views = 16;
  spec.rig.min_elevation = 48;
  spec.rig.max_elevation = 82;
  const SyntheticScene from_above = MakeScene(spec, Context(2));
  cup.views.insert(
      cup.views.end(), from_above.views.begin(), from_above.views.end());
  const ReconstructedScene scene =
      ReconstructScene(std::move(cup), QuickOptions());
  EXPECT_EQ(scene.result.audit.DescribeFailure(), "");
  const InsideTest inside(scene.mesh);
  const auto ring = [&](double radius, double z, bool expected) {
    int correct = 0;
    for (int i = 0; i < 12; ++i) {
      const double angle = 2 * kPi * (i + 0.5) / 12;
      const Eigen::Vector3d point(
          radius * std::cos(angle), radius * std::sin(angle), z);
      correct += inside(point) == expected;
    }
    return correct;
  };
  for (int i = 0; i < 9; ++i) {
    const double z = -0.3 + 0.1 * i;
    EXPECT_FALSE(inside({0, 0, z})) << z;
    EXPECT_GE(ring(0.25, z, false), 11) << z;
  }
  EXPECT_FALSE(inside({0, 0, -0.36}));
  for (int i = 0; i < 10; ++i) {
    const double z = -0.45 + 0.1 * i;
    EXPECT_EQ(ring(0.575, z, true), 12) << z;  // in the wall
  }
  EXPECT_EQ(ring(0.3, -0.5, true), 12);  // in the bottom
  const double solid = kPi * std::pow(0.65, 2) * 1.15;
  const double cavity = kPi * std::pow(0.5, 2) * 1.0;
  EXPECT_NEAR(scene.result.audit.volume, solid - cavity, 0.05 * solid);
}

TEST(Reconstruct, RodsOfThreeVoxelsAtTheHullsLevelAreStillThere) {
  SceneSpec spec = PipelineSpec("rods");
  spec.reference.resolution = 128;
  const ReconstructionOptions options = QuickOptions();
  // The cube is some 1.08 times 1.9 units.
  spec.parameters.rod_radius = 1.5 * 2.05 / (1 << options.hull.hull_level);
  const ReconstructedScene scene = ReconstructScene(spec, options);
  const double thickness = 2 * spec.parameters.rod_radius;
  EXPECT_LT(thickness,
            3.2 * scene.region.cube.VoxelSize(options.hull.hull_level));
  EXPECT_EQ(scene.result.audit.DescribeFailure(), "");
  EXPECT_EQ(scene.result.audit.num_components, 1u);
  EXPECT_LT(MeanDistance(scene.mesh, scene.synthetic.reference),
            scene.VoxelSize());
  const InsideTest inside(scene.mesh);
  const Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(20 * kPi / 180, Eigen::Vector3d(1, 1, 0.3).normalized())
          .toRotationMatrix();
  for (int axis = 0; axis < 3; ++axis) {
    // The round ends reach a radius beyond 0.9.
    for (int i = -45; i <= 45; ++i) {
      const double t = 0.02 * i;
      const Eigen::Vector3d point = tilt * (t * Eigen::Vector3d::Unit(axis));
      EXPECT_TRUE(inside(point)) << "rod " << axis << " at " << t;
    }
  }
}

TEST(Reconstruct, TouchingSpheresAreAManifold) {
  const ReconstructedScene scene =
      ReconstructScene(PipelineSpec("touching_spheres"), QuickOptions());
  ExpectNearReference(scene);
  EXPECT_GE(scene.result.audit.num_components, 1u);
  EXPECT_LE(scene.result.audit.num_components, 2u);
  EXPECT_EQ(scene.result.audit.genus, 0);
  const InsideTest inside(scene.mesh);
  EXPECT_TRUE(inside({-0.5, 0, 0}));
  EXPECT_TRUE(inside({0.5, 0, 0}));
  for (const double y : {-0.25, 0.25}) {
    EXPECT_FALSE(inside({0, y, 0}));
  }
}

}  // namespace
}  // namespace octacut
