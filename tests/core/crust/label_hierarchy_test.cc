#include "core/crust/label_hierarchy.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/crust/labeled_shapes.h"

namespace octacut {
namespace {

using testing::Ball;
using testing::LabelSolid;
using testing::Solid;

const Solid kBall = Ball({0.47, 0.52, 0.5}, 0.31);

// What the first coarser level that holds an ancestor says, naively.
float Expected(const std::vector<LabeledVoxels>& levels,
               const Eigen::Vector3i& voxel,
               int level) {
  for (auto it = levels.rbegin(); it != levels.rend(); ++it) {
    const int own = it->voxels.Level();
    if (own >= level) {
      continue;
    }
    Eigen::Vector3i child = voxel;
    for (int l = level; l > own + 1; --l) {
      child /= 2;
    }
    const Eigen::Vector3i parent = child / 2;
    const VoxelGrid::Index index = it->voxels.Find(parent);
    if (index == VoxelGrid::kNone) {
      continue;
    }
    int inside = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int face = 2 * axis + (child[axis] - 2 * parent[axis]);
      inside += (it->labels[index] >> face) & 1;
    }
    return float(inside) / 3;
  }
  return 0;
}

TEST(LabelHierarchy, WalksUpToTheFirstCrustThatHoldsAnAncestor) {
  std::vector<LabeledVoxels> levels = {LabelSolid(kBall, 3, 1e9),
                                       LabelSolid(kBall, 4, 3),
                                       LabelSolid(kBall, 5, 2)};
  LabelHierarchy hierarchy;
  EXPECT_TRUE(hierarchy.Empty());
  for (const LabeledVoxels& level : levels) {
    hierarchy.Add(level);
  }
  EXPECT_FALSE(hierarchy.Empty());
  EXPECT_EQ(hierarchy.Finest().voxels.Level(), 5);
  for (int level = 4; level <= 6; ++level) {
    const int n = 1 << level;
    int num_partial = 0;
    for (int i = 0; i < n * n * n; ++i) {
      const Eigen::Vector3i voxel(i % n, i / n % n, i / n / n);
      const float fraction = hierarchy.InsideFraction(voxel, level);
      ASSERT_EQ(fraction, Expected(levels, voxel, level))
          << level << ": " << voxel.transpose();
      num_partial += fraction > 0 && fraction < 1;
    }
    EXPECT_GT(num_partial, 0);
  }
}

TEST(LabelHierarchy, TellsInsideFromOutsideFarFromTheSurface) {
  LabelHierarchy hierarchy;
  hierarchy.Add(LabelSolid(kBall, 4, 1e9));
  hierarchy.Add(LabelSolid(kBall, 5, 2));
  constexpr int kLevel = 6;
  const int n = 1 << kLevel;
  for (int i = 0; i < n * n * n; ++i) {
    const Eigen::Vector3i voxel(i % n, i / n % n, i / n / n);
    const double distance =
        kBall((voxel.cast<double>().array() + 0.5).matrix() / n) * n;
    if (std::abs(distance) > 4) {
      ASSERT_EQ(hierarchy.InsideFraction(voxel, kLevel), distance < 0 ? 1 : 0)
          << voxel.transpose();
    }
  }
}

TEST(LabelHierarchy, IsOutsideWhereNothingIsKnown) {
  EXPECT_EQ(LabelHierarchy().InsideFraction({1, 2, 3}, 4), 0);
  LabelHierarchy hierarchy;
  LabeledVoxels one;
  one.voxels = VoxelGrid::FromCodes(2, {EncodeMorton(1, 1, 1)});
  one.labels = {kAllFaces};
  hierarchy.Add(one);
  EXPECT_EQ(hierarchy.InsideFraction({2, 3, 2}, 3), 1);
  EXPECT_EQ(hierarchy.InsideFraction({5, 4, 7}, 4), 1);
  EXPECT_EQ(hierarchy.InsideFraction({4, 3, 2}, 3), 0);
  // A level's own labels do not count for it.
  EXPECT_EQ(hierarchy.InsideFraction({1, 1, 1}, 2), 0);
}

TEST(LabelHierarchy, SharesOfACutVoxelFollowItsFaces) {
  LabelHierarchy hierarchy;
  LabeledVoxels one;
  one.voxels = VoxelGrid::FromCodes(1, {EncodeMorton(0, 0, 0)});
  one.labels = {FaceLabels(1 << 1 | 1 << 2)};  // x+ and y-
  hierarchy.Add(one);
  EXPECT_FLOAT_EQ(hierarchy.InsideFraction({1, 0, 0}, 2), 2.0f / 3);
  EXPECT_FLOAT_EQ(hierarchy.InsideFraction({1, 1, 0}, 2), 1.0f / 3);
  EXPECT_FLOAT_EQ(hierarchy.InsideFraction({0, 0, 1}, 2), 1.0f / 3);
  EXPECT_FLOAT_EQ(hierarchy.InsideFraction({0, 1, 1}, 2), 0);
}

TEST(LabelHierarchy, GrowsByOneLabelledLevelAtATime) {
  LabelHierarchy hierarchy;
  hierarchy.Add(LabelSolid(kBall, 3, 1e9));
  EXPECT_THROW(hierarchy.Add(LabelSolid(kBall, 3, 1e9)), InvariantError);
  EXPECT_THROW(hierarchy.Add(LabelSolid(kBall, 5, 1)), InvariantError);
  LabeledVoxels short_of_labels = LabelSolid(kBall, 4, 2);
  short_of_labels.labels.pop_back();
  EXPECT_THROW(hierarchy.Add(short_of_labels), InvariantError);
  EXPECT_NO_THROW(hierarchy.Add(LabelSolid(kBall, 4, 2)));
}

}  // namespace
}  // namespace octacut
