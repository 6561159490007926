#include "core/extract/split_loops.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

#include "core/extract/cube_topology.h"

namespace octacut {
namespace {

bool IsCubeEdge(int a, int b) { return std::popcount(SharedAxes(a, b)) == 2; }

TEST(CubeTopology, OctahedronEdgesAreDualToCubeEdges) {
  // Octahedron edges join faces that are not opposite; each such pair of
  // faces meets in one cube edge, and every cube edge is met once.
  std::set<std::pair<int, int>> octahedron_edges;
  int num_cube_edges = 0;
  for (int a = 0; a < kNumCorners; ++a) {
    for (int b = a + 1; b < kNumCorners; ++b) {
      if (!IsCubeEdge(a, b)) {
        continue;
      }
      ++num_cube_edges;
      std::vector<int> faces;
      for (int axis = 0; axis < 3; ++axis) {
        if (FaceAtCorner(a, axis) == FaceAtCorner(b, axis)) {
          faces.push_back(FaceAtCorner(a, axis));
        }
      }
      ASSERT_EQ(faces.size(), 2);
      EXPECT_NE(faces[0], OppositeFace(faces[1]));
      octahedron_edges.emplace(faces[0], faces[1]);
    }
  }
  EXPECT_EQ(num_cube_edges, 12);
  EXPECT_EQ(octahedron_edges.size(), 12);
}

TEST(CubeTopology, SplitEdgesAreTheCutOctahedronEdges) {
  for (int labels = 0; labels < 64; ++labels) {
    int num_cut = 0;
    for (int f = 0; f < kNumFaces; ++f) {
      for (int g = f + 1; g < kNumFaces; ++g) {
        num_cut +=
            g != OppositeFace(f) && (labels >> f & 1) != (labels >> g & 1);
      }
    }
    int num_split = 0;
    for (int a = 0; a < kNumCorners; ++a) {
      for (int b = a + 1; b < kNumCorners; ++b) {
        num_split += IsCubeEdge(a, b) && IsSplitEdge(FaceLabels(labels), a, b);
      }
    }
    EXPECT_EQ(num_split, num_cut) << "labels " << labels;
  }
}

TEST(CubeTopology, ChordNumbersAreUnique) {
  std::set<int> numbers;
  for (int a = 0; a < kNumCorners; ++a) {
    for (int b = a + 1; b < kNumCorners; ++b) {
      EXPECT_EQ(ChordNumber(a, b), ChordNumber(b, a));
      if ((a ^ b) == 7) {
        EXPECT_EQ(ChordNumber(a, b), -1);
      } else {
        EXPECT_TRUE(numbers.insert(ChordNumber(a, b)).second);
      }
    }
  }
  EXPECT_EQ(numbers.size(), 24);
  EXPECT_EQ(*numbers.begin(), 0);
  EXPECT_EQ(*numbers.rbegin(), 23);
}

TEST(SplitLoops, AllLabellingsRunThroughEverySplitEdgeOnce) {
  for (int labels = 0; labels < 64; ++labels) {
    SCOPED_TRACE(labels);
    const SplitLoops& loops = kSplitLoopTable[labels];
    EXPECT_EQ(loops.num_loops > 0, IsCut(FaceLabels(labels)));
    std::set<std::pair<int, int>> edges;
    unsigned corner_mask = 0;
    for (int i = 0; i < loops.num_loops; ++i) {
      const SplitLoop& loop = loops.loops[i];
      EXPECT_TRUE(loop.size == 4 || loop.size == 6 || loop.size == 8);
      for (int j = 0; j < loop.size; ++j) {
        const int a = loop.corners[j];
        const int b = loop.corners[(j + 1) % loop.size];
        EXPECT_TRUE(IsCubeEdge(a, b));
        EXPECT_TRUE(IsSplitEdge(FaceLabels(labels), a, b));
        EXPECT_TRUE(edges.emplace(std::min(a, b), std::max(a, b)).second);
        EXPECT_EQ(corner_mask >> a & 1, 0) << "corner " << a << " twice";
        corner_mask |= 1u << a;
      }
    }
    EXPECT_EQ(corner_mask, loops.corner_mask);
    size_t num_split = 0;
    for (int a = 0; a < kNumCorners; ++a) {
      for (int b = a + 1; b < kNumCorners; ++b) {
        num_split += IsCubeEdge(a, b) && IsSplitEdge(FaceLabels(labels), a, b);
      }
    }
    EXPECT_EQ(edges.size(), num_split);
  }
}

TEST(SplitLoops, SizesByNumberOfInsideFaces) {
  int with_two_loops = 0;
  int with_eight_corners = 0;
  for (int labels = 1; labels < 63; ++labels) {
    const SplitLoops& loops = kSplitLoopTable[labels];
    const int num_inside = std::popcount(unsigned(labels));
    if (num_inside == 1 || num_inside == 5) {
      EXPECT_EQ(loops.num_loops, 1);
      EXPECT_EQ(loops.loops[0].size, 4);
    }
    with_two_loops += loops.num_loops == 2;
    with_eight_corners += loops.num_loops == 1 && loops.loops[0].size == 8;
  }
  // Two opposite faces alike: 3 axes, inside or outside. Bands of three faces
  // around an axis: 12 of them (the middle one and the two sides next to it).
  EXPECT_EQ(with_two_loops, 6);
  EXPECT_EQ(with_eight_corners, 12);
}

TEST(SplitLoops, LoopOfOneInsideFaceFacesAwayFromIt) {
  for (int face = 0; face < kNumFaces; ++face) {
    const SplitLoop& loop = kSplitLoopTable[1 << face].loops[0];
    ASSERT_EQ(loop.size, 4);
    int corner[3][3];
    for (int j = 0; j < 3; ++j) {
      for (int axis = 0; axis < 3; ++axis) {
        corner[j][axis] = loop.corners[j] >> axis & 1;
      }
    }
    const int axis = face / 2;
    const int b = NextAxis(axis);
    const int c = NextAxis(b);
    const int normal =
        (corner[1][b] - corner[0][b]) * (corner[2][c] - corner[0][c]) -
        (corner[1][c] - corner[0][c]) * (corner[2][b] - corner[0][b]);
    EXPECT_EQ(normal, face & 1 ? -1 : 1) << "face " << face;
  }
}

TEST(SplitLoops, ComplementRunsTheOtherWay) {
  for (int labels = 1; labels < 63; ++labels) {
    const SplitLoops& loops = kSplitLoopTable[labels];
    const SplitLoops& complement = kSplitLoopTable[63 - labels];
    ASSERT_EQ(loops.num_loops, complement.num_loops);
    for (int i = 0; i < loops.num_loops; ++i) {
      const SplitLoop& loop = loops.loops[i];
      const SplitLoop& other = complement.loops[i];
      ASSERT_EQ(loop.size, other.size);
      for (int j = 0; j < loop.size; ++j) {
        EXPECT_EQ(loop.corners[j], other.corners[(loop.size - j) % loop.size]);
      }
    }
  }
}

}  // namespace
}  // namespace octacut
