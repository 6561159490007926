#include "core/cut/octahedron.h"

#include <gtest/gtest.h>

#include <set>

#include "core/cut/bucket_queue.h"
#include "core/grid/voxel_walk.h"
#include "tests/core/cut/cut_test_problems.h"

namespace octacut {
namespace {

TEST(Octahedron, ArcsJoinFacesOfDifferentAxesAndComeInPairs) {
  std::set<int> edges;
  for (int arc = 0; arc < kNumOctahedronArcs; ++arc) {
    const int reverse = kOctahedron.reverse[arc];
    EXPECT_NE(kOctahedron.head[arc] / 2, arc / 4 / 2);
    EXPECT_EQ(kOctahedron.head[reverse], arc / 4);
    EXPECT_EQ(kOctahedron.head[arc], reverse / 4);
    EXPECT_EQ(kOctahedron.reverse[reverse], arc);
    EXPECT_EQ(kOctahedron.edge[reverse], kOctahedron.edge[arc]);
    EXPECT_EQ(kOctahedron.sign[reverse], -kOctahedron.sign[arc]);
    edges.insert(kOctahedron.edge[arc]);
  }
  EXPECT_EQ(edges.size(), size_t(kNumOctahedronEdges));
}

TEST(Octahedron, ArcsInAndOutSelectTheFacesAround) {
  for (int arc = 0; arc < kNumOctahedronArcs; ++arc) {
    for (int face = 0; face < kNumFaces; ++face) {
      const uint32_t out = arc / 4 == face ? 1u << (arc % 4) : 0;
      EXPECT_EQ(ArcsOut(1u << arc, face), out);
      const uint32_t in = kOctahedron.head[arc] == face
                              ? 1u << (kOctahedron.reverse[arc] % 4)
                              : 0;
      EXPECT_EQ(ArcsIn(1u << arc, face), in);
    }
  }
}

// Nodes of a full grid: following an arc and its way back returns.
TEST(Octahedron, NodeArcsLeadBack) {
  const VoxelGrid grid =
      VoxelGrid::FromCodes(4, BoxCodes({2, 2, 2}, {9, 9, 9}));
  const VoxelWalk walk(grid, Context(1));
  const VoxelGrid::Index centre = grid.Find(Eigen::Vector3i(7, 7, 8));
  walk.ForEach(0, walk.NumBricks(), [&](const VoxelSlot& slot) {
    if (slot.index != centre) {
      return;
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (int code = 0; code < kNumNodeArcs; ++code) {
        const auto follow = [&](const VoxelSlot& from, int from_axis, int c) {
          const NodeArc& arc = kNodeArcs[from_axis][c];
          const VoxelSlot holder =
              arc.side ? walk.Step(from, 2 * from_axis) : from;
          return walk.Step(holder, arc.step);
        };
        const NodeArc& arc = kNodeArcs[axis][code];
        const VoxelSlot other = follow(slot, axis, code);
        const NodeArc& back = kNodeArcs[arc.axis][arc.back];
        EXPECT_EQ(follow(other, arc.axis, arc.back).index, slot.index);
        EXPECT_EQ(back.axis, axis);
        EXPECT_EQ(back.back, code);
        EXPECT_EQ(back.out, arc.in);
        EXPECT_EQ(back.in, arc.out);
      }
    }
  });
}

TEST(BucketQueue, KeepsOrderAndReusesChunks) {
  ChunkPool pool;
  BucketQueue queue;
  EXPECT_TRUE(queue.Empty());
  for (int round = 0; round < 50; ++round) {
    for (uint32_t item = 0; item < 1000; ++item) {
      queue.Add(int32_t(3 + item % 7), item % 3, item, pool);
    }
    EXPECT_EQ(queue.Lowest(), 3);
    EXPECT_EQ(queue.Highest(), 9);
    uint32_t taken = 0;
    for (int32_t level = 3; level <= 9; ++level) {
      std::array<uint32_t, 3> previous = {0, 0, 0};
      queue.Consume(
          level,
          pool,
          [](auto, uint32_t) {},
          [&](auto axis, uint32_t item) {
            EXPECT_EQ(int32_t(3 + item % 7), level);
            EXPECT_EQ(int(item % 3), axis());
            EXPECT_GE(item, previous[axis]);
            previous[axis] = item;
            ++taken;
          });
    }
    EXPECT_EQ(taken, 1000u);
    EXPECT_TRUE(queue.Empty());
  }
  EXPECT_LE(pool.MemoryBytes(), size_t(2 * 256 * 256));
}

}  // namespace
}  // namespace octacut
