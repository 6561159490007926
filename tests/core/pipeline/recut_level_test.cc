#include "core/pipeline/recut_level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/extract/extract_surface.h"
#include "core/grid/morphology.h"
#include "core/hull/visual_hull.h"
#include "tests/core/extract/label_crust.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::TestScene;

constexpr double kRecutCupDepth = 0.5;  // and its width is 1

// A cup, the hull of whose photographs fills its cavity.
class RecutLevelTest : public ::testing::Test {
 protected:
  RecutLevelTest() {
    options_.hull.hull_level = 5;
    options_.target_level = 6;
    hull_ = ComputeVisualHull(
                test_.views, TestScene::UnitBox(), options_.hull, Context(2))
                .voxels;
    evidence_.mask_confidence.assign(test_.views.size(), 1.0f);
    evidence_.depth_confidence = {hull_,
                                  std::vector<float>(hull_.Size(), 1.0f)};
    evidence_.decision_confidence = evidence_.depth_confidence;
  }

  // The surface at that distance from the cup's, outside, unit coordinates.
  IndexedMesh Mesh(double distance) const {
    return Place(LabelShape(6,
                            [&](const Eigen::Vector3d& x) {
                              return (test_.Value(x) - distance) /
                                     test_.region.cube.edge;
                            }),
                 UnitCube());
  }

  LabeledVoxels Recut(const IndexedMesh& mesh, int level = 6) {
    return RecutLevel(inputs_, hull_, mesh, level, &hierarchy_, &summary_)
        .surface;
  }

  TestScene test_ = testing::MakeOpenCup(kRecutCupDepth);
  ReconstructionOptions options_;
  VoxelGrid hull_;
  InsideEvidence evidence_;
  Context context_{2};
  LevelInputs inputs_{test_.views, evidence_, options_, context_};
  LabelHierarchy hierarchy_;
  LevelSummary summary_;
};

TEST_F(RecutLevelTest, CutsAroundTheMesh) {
  const double voxel = test_.VoxelSize(6);
  const LabeledVoxels surface = Recut(Mesh(voxel));
  EXPECT_EQ(summary_.num_crust_voxels, surface.voxels.Size());
  size_t num_clear = 0;
  size_t num_right = 0;
  surface.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const double distance =
        test_.Value(VoxelCenter(DecodeMorton(code), 6).cast<double>());
    // The crust is around the mesh, as wide as any.
    EXPECT_LT(std::abs(distance - voxel),
              (options_.crust.HalfWidth() + 2) * 1.8 * voxel);
    if (std::abs(distance) > 1.5 * voxel) {
      ++num_clear;
      num_right += surface.labels[index] == (distance < 0 ? kAllFaces : 0);
    }
  });
  ASSERT_GT(num_clear, 10000u);
  // Photographs lead it from where the mesh is to where the cup is.
  EXPECT_GT(double(num_right), 0.95 * double(num_clear));
}

// As where masks are too small: what is inside of the mesh and out of the hull
// is inside.
TEST_F(RecutLevelTest, LeavesTheHull) {
  std::vector<uint8_t> is_kept;
  hull_.ForEach([&](VoxelGrid::Index, MortonCode code) {
    is_kept.push_back(DecodeMorton(code).x() < hull_.Resolution() / 2);
  });
  hull_ = Subset(hull_, is_kept);
  const LabeledVoxels surface = Recut(Mesh(0));
  const ExtractedSurface extracted = ExtractSurface(
      surface.voxels, surface.labels, test_.region.cube, context_);
  EXPECT_GT(extracted.mesh.triangles.size(), 1000u);
}

TEST_F(RecutLevelTest, CutsAFinerLevel) {
  const LabeledVoxels surface = Recut(Mesh(0), 7);
  EXPECT_EQ(surface.voxels.Level(), 7);
  ASSERT_FALSE(hierarchy_.Empty());
  EXPECT_EQ(hierarchy_.Finest().voxels.Level(), 6);
  const IndexedMesh mesh =
      ExtractSurface(
          surface.voxels, surface.labels, test_.region.cube, context_)
          .mesh;
  ASSERT_GT(mesh.positions.size(), 10000u);
  size_t num_near = 0;
  for (const Eigen::Vector3d& position : mesh.positions) {
    num_near += std::abs(test_.Value(test_.region.cube.ToUnit(position))) <
                2 * test_.VoxelSize(7);
  }
  EXPECT_GT(double(num_near), 0.95 * double(mesh.positions.size()));
}

TEST_F(RecutLevelTest, KnowsInsideAndOutsideByTheMesh) {
  Recut(Mesh(0));
  const double coarse = test_.VoxelSize(5);
  ASSERT_FALSE(hierarchy_.Empty());
  EXPECT_EQ(hierarchy_.Finest().voxels.Level(), 5);
  size_t num_cavity = 0;
  hull_.ForEach([&](VoxelGrid::Index, MortonCode code) {
    const double distance =
        test_.Value(VoxelCenter(DecodeMorton(code), 5).cast<double>());
    if (std::abs(distance) > 1.5 * coarse) {
      num_cavity += distance > 0;
      EXPECT_EQ(hierarchy_.InsideFraction(2 * DecodeMorton(code), 6),
                distance < 0 ? 1 : 0);
    }
  });
  EXPECT_GT(num_cavity, 500u);
}

}  // namespace
}  // namespace octacut
