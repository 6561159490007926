#include "core/grid/voxel_grid.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/grid/morphology.h"
#include "tests/core/grid/codes_of.h"

namespace octacut {
namespace {

std::vector<MortonCode> RandomCodes(int level, size_t count, uint32_t seed) {
  std::mt19937 random(seed);
  const uint32_t extent = 1u << level;
  std::vector<MortonCode> codes;
  for (size_t i = 0; i < count; ++i) {
    codes.push_back(
        EncodeMorton(random() % extent, random() % extent, random() % extent));
  }
  return codes;
}

TEST(Morton, DecodeInvertsEncodeUpToTheLargestCoordinate) {
  std::mt19937 random(1);
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Vector3i voxel(
        random() % (1 << 20), random() % (1 << 20), random() % (1 << 20));
    EXPECT_EQ(DecodeMorton(EncodeMorton(voxel)), voxel);
  }
  EXPECT_EQ(EncodeMorton(1, 0, 0), 1u);
  EXPECT_EQ(EncodeMorton(0, 1, 0), 2u);
  EXPECT_EQ(EncodeMorton(0, 0, 1), 4u);
}

TEST(Morton, ParentHalvesTheCoordinates) {
  std::mt19937 random(2);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3i voxel(
        random() % 4096, random() % 4096, random() % 4096);
    EXPECT_EQ(DecodeMorton(ParentCode(EncodeMorton(voxel))),
              Eigen::Vector3i(voxel / 2));
  }
}

TEST(VoxelGrid, FindsExactlyItsVoxelsInMortonOrder) {
  const int level = 6;
  const std::vector<MortonCode> codes = RandomCodes(level, 5000, 3);
  const std::set<MortonCode> expected(codes.begin(), codes.end());
  const VoxelGrid grid = VoxelGrid::FromCodes(level, codes);
  ASSERT_EQ(grid.Size(), expected.size());
  VoxelGrid::Index next = 0;
  auto it = expected.begin();
  grid.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    EXPECT_EQ(index, next++);
    EXPECT_EQ(code, *it++);
    EXPECT_EQ(grid.Find(code), index);
  });
  EXPECT_EQ(next, grid.Size());
  for (MortonCode code = 0; code < (1u << (3 * level)); code += 7) {
    EXPECT_EQ(grid.Find(code) != VoxelGrid::kNone, expected.count(code) == 1);
  }
}

TEST(VoxelGrid, KnowsNothingOutsideTheCube) {
  const VoxelGrid grid = VoxelGrid::FromCodes(2, RandomCodes(2, 500, 4));
  EXPECT_FALSE(grid.Contains({-1, 0, 0}));
  EXPECT_FALSE(grid.Contains({0, 4, 0}));
  EXPECT_FALSE(VoxelGrid().Contains({0, 0, 0}));
}

TEST(VoxelGrid, FindsTheVoxelThatHoldsAPoint) {
  const VoxelGrid grid = VoxelGrid::FromCodes(
      2, {EncodeMorton({0, 0, 0}), EncodeMorton({1, 2, 3})});
  EXPECT_EQ(grid.FindAt({0, 0, 0}), 0u);
  EXPECT_EQ(grid.FindAt({0.25f, 0.74f, 0.99f}), 1u);
  EXPECT_EQ(grid.FindAt({0.24f, 0.74f, 0.99f}), VoxelGrid::kNone);
  EXPECT_EQ(grid.FindAt({0, 0, -0.01f}), VoxelGrid::kNone);
  EXPECT_EQ(grid.FindAt({0.25f, 0.74f, 1}), VoxelGrid::kNone);
}

class MorphologyTest : public testing::TestWithParam<int> {};

std::set<MortonCode> BruteDilate(const std::set<MortonCode>& codes,
                                 int level,
                                 bool all_neighbors) {
  std::set<MortonCode> out = codes;
  const int extent = 1 << level;
  for (const MortonCode code : codes) {
    const Eigen::Vector3i v = DecodeMorton(code);
    for (int n = 0; n < 27; ++n) {
      const Eigen::Vector3i d(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      const Eigen::Vector3i w = v + d;
      if ((all_neighbors || d.cwiseAbs().sum() <= 1) &&
          (w.array() >= 0).all() && (w.array() < extent).all()) {
        out.insert(EncodeMorton(w));
      }
    }
  }
  return out;
}

TEST_P(MorphologyTest, DilationMatchesBruteForce) {
  const int level = GetParam();
  const std::vector<MortonCode> codes =
      RandomCodes(level, level < 2 ? 1 : 40, 5 + level);
  std::set<MortonCode> expected(codes.begin(), codes.end());
  const Context context(1);
  for (int steps = 1; steps <= 3; ++steps) {
    expected = BruteDilate(expected, level, steps % 2 == 1);
    const VoxelGrid dilated =
        Dilate(VoxelGrid::FromCodes(level, codes), steps, context);
    EXPECT_EQ(CodesOf(dilated),
              std::vector<MortonCode>(expected.begin(), expected.end()))
        << steps << " steps";
  }
}

TEST_P(MorphologyTest, ChildrenAreAllEight) {
  const int level = GetParam();
  const std::vector<MortonCode> codes = RandomCodes(level, 40, 6);
  std::set<MortonCode> expected;
  for (const MortonCode code : codes) {
    for (int child = 0; child < 8; ++child) {
      expected.insert(FirstChildCode(code) + child);
    }
  }
  const VoxelGrid children = Children(VoxelGrid::FromCodes(level, codes));
  EXPECT_EQ(children.Level(), level + 1);
  EXPECT_EQ(CodesOf(children),
            std::vector<MortonCode>(expected.begin(), expected.end()));
}

INSTANTIATE_TEST_SUITE_P(Levels,
                         MorphologyTest,
                         testing::Values(0, 1, 2, 3, 5));

TEST(Morphology, SubsetAndUnionAreComplementary) {
  const VoxelGrid grid = VoxelGrid::FromCodes(5, RandomCodes(5, 3000, 8));
  std::vector<uint8_t> keep(grid.Size());
  std::vector<uint8_t> drop(grid.Size());
  for (size_t i = 0; i < keep.size(); ++i) {
    keep[i] = i % 3 == 0;
    drop[i] = !keep[i];
  }
  const VoxelGrid kept = Subset(grid, keep);
  EXPECT_EQ(kept.Size(), (grid.Size() + 2) / 3);
  EXPECT_EQ(CodesOf(Union(kept, Subset(grid, drop))), CodesOf(grid));
}

}  // namespace
}  // namespace octacut
