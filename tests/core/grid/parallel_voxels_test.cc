#include "core/grid/parallel_voxels.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/error.h"
#include "tests/core/grid/codes_of.h"

namespace octacut {
namespace {

VoxelGrid ScatteredGrid() {
  std::vector<MortonCode> codes;
  for (MortonCode code = 0; code < 64u * 64 * 64; code += 7) {
    codes.push_back(code);
  }
  return VoxelGrid::FromCodes(6, codes);
}

TEST(ParallelForVoxels, VisitsEachVoxelOnceForAnyNumberOfThreads) {
  const VoxelGrid grid = ScatteredGrid();
  for (const int num_threads : {1, 4}) {
    std::vector<int> visits(grid.Size());
    std::vector<MortonCode> codes(grid.Size());
    ParallelForVoxels(Context(num_threads),
                      grid,
                      [&](VoxelGrid::Index index, MortonCode code) {
                        ++visits[index];
                        codes[index] = code;
                      });
    EXPECT_EQ(visits, std::vector<int>(grid.Size(), 1));
    EXPECT_EQ(codes, CodesOf(grid));
  }
  ParallelForVoxels(Context(2), VoxelGrid(), [](VoxelGrid::Index, MortonCode) {
    ADD_FAILURE() << "a voxel of an empty grid";
  });
}

TEST(ParallelForVoxels, PassesErrorsOn) {
  EXPECT_THROW(ParallelForVoxels(Context(2),
                                 ScatteredGrid(),
                                 [](VoxelGrid::Index index, MortonCode) {
                                   if (index == 5000) {
                                     throw InputError("voxel 5000");
                                   }
                                 }),
               InputError);
}

}  // namespace
}  // namespace octacut
