#include "core/pipeline/hull_border.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/mesh/normals.h"
#include "core/mesh/untangle.h"
#include "tests/core/verdict/sphere_views.h"

namespace octacut {
namespace {

using testing::MakeSphereViews;
using testing::SphereViews;

constexpr int kBorderLevel = 6;

class MoveToHullBorderTest : public ::testing::Test {
 protected:
  // The object as a cut has it: vertices are off by up to half a voxel. Beside
  // it, what is deep inside: smaller balls.
  MoveToHullBorderTest() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> noise(-0.5, 0.5);
    mesh_ = SphereViews::Ball(1);
    num_outer_ = mesh_.positions.size();
    for (Eigen::Vector3d& position : mesh_.positions) {
      position *= 1 + noise(random) * voxel_ / SphereViews::kRadius;
    }
    const IndexedMesh inner = SphereViews::Ball(0.5);
    mesh_.positions.insert(
        mesh_.positions.end(), inner.positions.begin(), inner.positions.end());
    for (const std::array<uint32_t, 3>& t : inner.triangles) {
      mesh_.triangles.push_back({uint32_t(t[0] + num_outer_),
                                 uint32_t(t[1] + num_outer_),
                                 uint32_t(t[2] + num_outer_)});
    }
    RoundToFloats(&mesh_.positions);
    mesh_.normals = ComputeVertexNormals(mesh_, Context(2));
    std::vector<MortonCode> codes(size_t{1} << (3 * kBorderLevel));
    for (size_t i = 0; i < codes.size(); ++i) {
      codes[i] = i;
    }
    voxels_ = VoxelGrid::FromCodes(kBorderLevel, codes);
  }

  size_t Move(float decided, float mask_confidence, IndexedMesh* mesh) const {
    return MoveToHullBorder(
        {sphere_.test.views,
         std::vector<float>(sphere_.test.views.size(), mask_confidence),
         sphere_.test.region.cube},
        {voxels_, std::vector<float>(voxels_.Size(), decided)},
        Context(num_threads_),
        mesh);
  }

  // Root mean square, in voxels.
  double OuterError(const IndexedMesh& mesh) const {
    double sum = 0;
    for (size_t v = 0; v < num_outer_; ++v) {
      sum += std::pow(mesh.positions[v].norm() - SphereViews::kRadius, 2);
    }
    return std::sqrt(sum / double(num_outer_)) / voxel_;
  }

  SphereViews sphere_ = MakeSphereViews();
  double voxel_ = sphere_.test.region.cube.VoxelSize(kBorderLevel);
  IndexedMesh mesh_;
  size_t num_outer_ = 0;
  VoxelGrid voxels_;
  int num_threads_ = 2;
};

TEST_F(MoveToHullBorderTest, TakesTheErrorOfTheCut) {
  IndexedMesh undecided = mesh_;
  EXPECT_GT(Move(0, 1, &undecided), num_outer_ / 2);
  EXPECT_LT(OuterError(undecided), 0.5 * OuterError(mesh_));
  // Less where the cut is known better.
  IndexedMesh decided = mesh_;
  Move(1, 1, &decided);
  EXPECT_LT(OuterError(decided), 0.9 * OuterError(mesh_));
  EXPECT_GT(OuterError(decided), OuterError(undecided));
}

TEST_F(MoveToHullBorderTest, LeavesWhatIsInside) {
  IndexedMesh moved = mesh_;
  Move(0, 1, &moved);
  for (size_t v = num_outer_; v < mesh_.positions.size(); ++v) {
    EXPECT_EQ(moved.positions[v], mesh_.positions[v]);
  }
}

TEST_F(MoveToHullBorderTest, IsNotLedByMasksThatAreInDoubt) {
  IndexedMesh moved = mesh_;
  EXPECT_EQ(Move(0, 0.4f, &moved), 0u);
  EXPECT_EQ(moved.positions, mesh_.positions);
}

TEST_F(MoveToHullBorderTest, DoesNotDependOnTheNumberOfThreads) {
  IndexedMesh one = mesh_;
  IndexedMesh two = mesh_;
  Move(0.3f, 1, &two);
  num_threads_ = 1;
  Move(0.3f, 1, &one);
  EXPECT_EQ(one.positions, two.positions);
}

}  // namespace
}  // namespace octacut
