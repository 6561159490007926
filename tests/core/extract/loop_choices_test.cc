#include "core/extract/loop_choices.h"

#include <gtest/gtest.h>

#include "core/extract/cube_topology.h"
#include "core/mesh/triangle_intersection.h"

namespace octacut {
namespace {

Eigen::Vector3d Corner(int k) {
  return Eigen::Vector3i(k & 1, k >> 1 & 1, k >> 2 & 1).cast<double>();
}

bool HasIntersections(const SplitLoop& loop, int choice) {
  std::vector<TriangleCorners> triangles;
  for (const LoopTriangle& t : LoopTriangulation(loop.size, choice)) {
    triangles.push_back({Corner(loop.corners[t[0]]),
                         Corner(loop.corners[t[1]]),
                         Corner(loop.corners[t[2]])});
  }
  for (size_t i = 0; i < triangles.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      if (TrianglesIntersect(triangles[i], triangles[j])) {
        return true;
      }
    }
  }
  return false;
}

TEST(CrossesItself, OfEveryTriangulationOfEveryLoop) {
  size_t num_crossing = 0;
  for (int labels = 1; labels < 63; ++labels) {
    const SplitLoops& loops = kSplitLoopTable[labels];
    for (int i = 0; i < loops.num_loops; ++i) {
      const SplitLoop& loop = loops.loops[i];
      const int num_choices =
          int(LoopTriangulations(loop.size).size()) / (loop.size - 2);
      for (int choice = 0; choice < num_choices; ++choice) {
        const bool crosses = HasIntersections(loop, choice);
        EXPECT_EQ(CrossesItself(loop, choice), crosses)
            << "labels " << labels << ", loop " << i << ", choice " << choice;
        num_crossing += crosses ? 1 : 0;
      }
    }
  }
  EXPECT_GT(num_crossing, 0u);
}

}  // namespace
}  // namespace octacut
