#include "core/pipeline/build_mesh.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/benchmark/synthetic/material.h"
#include "tests/core/pipeline/reconstruction_checks.h"

namespace octacut {
namespace {

using testing::PipelineSpec;
using testing::QuickOptions;
using testing::ReconstructedScene;
using testing::ReconstructScene;

// 64^3 to 128^3.
ReconstructionOptions FinerOptions() {
  ReconstructionOptions options;
  options.hull.hull_level = 6;
  options.target_level = 7;
  return options;
}

// The cup is filled by its hull and opened by refinement.
TEST(BuildMesh, CutsAgainWhereRefinementLeavesTheCrust) {
  SceneSpec spec = PipelineSpec("cup");
  spec.rig.num_views = 16;
  const ReconstructedScene scene = ReconstructScene(spec, FinerOptions());
  const ReconstructionSummary& summary = scene.result.summary;
  const std::vector<double>& moved = summary.recuts.moved;
  ASSERT_GE(moved.size(), 2u);
  EXPECT_LE(moved.size(), 3u);
  EXPECT_GT(moved.front(), 0.01);
  EXPECT_LT(moved.back(), moved.front() / 2);
  EXPECT_GE(summary.recuts.num_kept, 1);
  EXPECT_EQ(scene.result.audit.DescribeFailure(), "");
  // The levels of the mesh that is kept.
  ASSERT_EQ(summary.levels.size(), 2u);
  EXPECT_EQ(summary.levels[0].level, 6);
  EXPECT_EQ(summary.levels[1].level, 7);
}

// By 0.019 less.
TEST(BuildMesh, UndoesACutOverWhichPhotographsAgreeLess) {
  SceneSpec spec = PipelineSpec("fingers");
  spec.rig.num_views = 14;
  spec.material = MaterialKind::kPlaster;
  const ReconstructedScene scene = ReconstructScene(spec, FinerOptions());
  const ReconstructionSummary& summary = scene.result.summary;
  EXPECT_EQ(summary.recuts.num_kept, 0);
  ASSERT_EQ(summary.recuts.agreements.size(), 2u);
  EXPECT_LT(summary.recuts.agreements[1], summary.recuts.agreements[0] - 0.003);
  // The mesh is what it was before the cut.
  ASSERT_EQ(summary.levels.size(), 2u);
  EXPECT_EQ(summary.levels[1].level, 7);
  EXPECT_EQ(summary.refinement->agreement_after, summary.recuts.agreements[0]);
  EXPECT_EQ(scene.result.audit.DescribeFailure(), "");
}

TEST(BuildMesh, KeepsACutThatRefinementStaysNear) {
  const ReconstructedScene scene =
      ReconstructScene(PipelineSpec("sphere"), QuickOptions());
  ASSERT_EQ(scene.result.summary.recuts.moved.size(), 1u);
  EXPECT_LE(scene.result.summary.recuts.moved[0], 0.01);
}

// Where a bounding box cuts the object, its outlines pull the surface out of
// the box, where there are no voxels.
TEST(BuildMesh, KeepsACutWhoseRefinedSurfaceLeavesTheCube) {
  SceneSpec spec = PipelineSpec("cup", 96, 72);
  spec.parameters.cup_depth = 2;
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-0.7, -0.7, -1.0),
                                Eigen::Vector3d(0.7, 0.7, 0.9));
  const ReconstructedScene scene = ReconstructScene(
      MakeScene(spec, Context(2)), QuickOptions(), {.bounding_box = box});
  ASSERT_EQ(scene.result.summary.recuts.moved.size(), 1u);
  EXPECT_GT(scene.result.summary.recuts.moved[0], 0.01);
  EXPECT_EQ(scene.result.summary.recuts.num_kept, 0);
  EXPECT_EQ(scene.result.audit.DescribeFailure(), "");
}

TEST(BuildMesh, KeepsTheCutOfAMirror) {
  SceneSpec spec = PipelineSpec("lump");
  spec.material = MaterialKind::kMetal;
  const ReconstructedScene scene = ReconstructScene(spec, QuickOptions());
  EXPECT_EQ(scene.result.summary.recuts.moved.size(), 0u);
}

}  // namespace
}  // namespace octacut
