#include "core/crust/mesh_labels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/core/crust/labeled_shapes.h"
#include "tests/core/grid/codes_of.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

using testing::Ball;
using testing::FaceCenter;
using testing::LabelSolid;
using testing::Solid;

const Eigen::Vector3d kCenter(0.47, 0.52, 0.5);
constexpr double kRadius = 0.31;

IndexedMesh BallMesh(uint32_t n) {
  return Sphere(n, [](const Eigen::Vector3d& direction) -> Eigen::Vector3d {
    return kCenter + kRadius * direction;
  });
}

// A box of `n` x `n` squares a side.
IndexedMesh BoxMesh(uint32_t n,
                    const Eigen::Vector3d& min,
                    const Eigen::Vector3d& max) {
  IndexedMesh mesh = Cube(n);
  for (Eigen::Vector3d& position : mesh.positions) {
    position = min + position.cwiseProduct(max - min);
  }
  return mesh;
}

TEST(LabelByMesh, LabelsFacesWhoseCentersAreInside) {
  constexpr int kLevel = 5;
  const Solid ball = Ball(kCenter, kRadius);
  const LabeledVoxels all = LabelSolid(ball, kLevel, 1e9);
  const LabeledVoxels labeled =
      LabelByMesh(BallMesh(24), all.voxels, Context(1));
  ASSERT_EQ(labeled.labels.size(), all.labels.size());
  // Chords of a sphere lie below it.
  const double chord = 0.003;
  size_t num_inside = 0;
  all.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    for (int face = 0; face < kNumFaces; ++face) {
      const Eigen::Vector3d center =
          FaceCenter(DecodeMorton(code), face, kLevel);
      if (std::abs(ball(center)) > chord) {
        const bool is_inside = (labeled.labels[index] >> face) & 1;
        EXPECT_EQ(is_inside, ball(center) < 0) << center.transpose();
        num_inside += is_inside;
      }
    }
  });
  EXPECT_GT(num_inside, 20000u);
  EXPECT_EQ(LabelByMesh(BallMesh(24), all.voxels, Context(3)).labels,
            labeled.labels);
}

TEST(LabelByMesh, NeighborsAgree) {
  const LabeledVoxels labeled = LabelByMesh(
      BallMesh(9), LabelSolid(Ball(kCenter, kRadius), 6, 3).voxels, Context(2));
  labeled.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    for (const int face : {1, 3, 5}) {
      const VoxelGrid::Index other =
          labeled.voxels.Find(NeighborVoxel(DecodeMorton(code), face));
      if (other != VoxelGrid::kNone) {
        EXPECT_EQ((labeled.labels[index] >> face) & 1,
                  (labeled.labels[other] >> OppositeFace(face)) & 1);
      }
    }
  });
}

TEST(VoxelsOfMesh, HoldsWhatEveryTrianglePassesThrough) {
  const Eigen::Vector3d min(0.21, 0.33, 0.4);
  const Eigen::Vector3d max(0.83, 0.61, 0.47);
  // However large the triangles are.
  EXPECT_EQ(CodesOf(VoxelsOfMesh(BoxMesh(1, min, max), 5)),
            CodesOf(VoxelsOfMesh(BoxMesh(40, min, max), 5)));
  // A plate that no centre of a face is in.
  const Eigen::Vector3d top(0.83, 0.61, 0.405);
  std::vector<MortonCode> expected;
  for (int x = 6; x <= 26; ++x) {
    for (int y = 10; y <= 19; ++y) {
      expected.push_back(EncodeMorton({x, y, 12}));
    }
  }
  EXPECT_EQ(CodesOf(VoxelsOfMesh(BoxMesh(1, min, top), 5)),
            CodesOf(VoxelGrid::FromCodes(5, expected)));
}

TEST(VoxelsOfMesh, LeavesOutWhatIsOutsideOfTheCube) {
  const VoxelGrid voxels =
      VoxelsOfMesh(BoxMesh(4, {-0.2, 0.3, 0.3}, {1.2, 0.6, 0.6}), 4);
  ASSERT_GT(voxels.Size(), 0u);
  voxels.ForEach([&](VoxelGrid::Index, MortonCode code) {
    EXPECT_LT(DecodeMorton(code).maxCoeff(), 16);
  });
}

}  // namespace
}  // namespace octacut
