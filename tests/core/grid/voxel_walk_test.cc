#include "core/grid/voxel_walk.h"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>
#include <random>

#include "core/grid/count_bits.h"

namespace octacut {
namespace {

class VoxelWalkTest : public testing::TestWithParam<int> {};

TEST_P(VoxelWalkTest, NeighborsAreThoseOfTheGrid) {
  const int level = GetParam();
  std::mt19937 random(1);
  std::vector<MortonCode> codes(size_t{1} << (3 * level));
  std::iota(codes.begin(), codes.end(), 0);
  std::erase_if(codes, [&](MortonCode) { return random() % 3 == 0; });
  const VoxelGrid grid = VoxelGrid::FromCodes(level, codes);
  const VoxelWalk walk(grid, Context(2));
  size_t visited = 0;
  walk.ForEachWithNeighbors(
      0, walk.NumBricks(), [&](const VoxelSlot& slot, const auto& neighbors) {
        EXPECT_EQ(slot.index, visited++);
        const Eigen::Vector3i voxel = DecodeMorton(
            VoxelGrid::CodeOf(grid.Bricks()[slot.brick], int(slot.bit)));
        EXPECT_EQ(grid.Find(voxel), slot.index);
        for (int face = 0; face < kNumFaces; ++face) {
          const VoxelGrid::Index expected =
              grid.Find(NeighborVoxel(voxel, face));
          EXPECT_EQ(neighbors[face], expected);
          if (expected != VoxelGrid::kNone) {
            EXPECT_EQ(walk.Step(slot, face).index, expected);
          }
        }
      });
  EXPECT_EQ(visited, grid.Size());
}

INSTANTIATE_TEST_SUITE_P(Levels, VoxelWalkTest, testing::Values(0, 1, 2, 4, 6));

TEST(CountBits, CountsAsTheStandardLibraryDoes) {
  std::mt19937_64 random(1);
  for (const uint64_t x : {uint64_t{0}, ~uint64_t{0}, uint64_t{1} << 63}) {
    EXPECT_EQ(CountBits(x), std::popcount(x));
  }
  for (int k = 0; k < 1000; ++k) {
    const uint64_t x = random() & random();
    EXPECT_EQ(CountBits(x), std::popcount(x)) << x;
  }
}

TEST(VoxelWalk, SumsOverNeighboringBricks) {
  // Bricks in a row along x, of which the third is missing.
  std::vector<MortonCode> codes;
  for (const int x : {0, 4, 12, 16}) {
    codes.push_back(EncodeMorton(Eigen::Vector3i(x, 0, 0)));
  }
  const VoxelGrid grid = VoxelGrid::FromCodes(5, codes);
  const VoxelWalk walk(grid, Context(1));
  EXPECT_EQ(walk.SumOverBrickNeighbors({1, 2, 4, 8}),
            (std::vector<float>{3, 3, 12, 12}));
}

}  // namespace
}  // namespace octacut
