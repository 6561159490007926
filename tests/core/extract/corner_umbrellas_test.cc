#include "core/extract/corner_umbrellas.h"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

namespace octacut {
namespace {

bool IsInside(int labels, int octant, int axis) {
  return labels >> QuarterFace(octant, axis) & 1;
}

// The six grid edges at the corner, as axis and side. An octant's polygon
// runs along an edge on its side if its two quarter faces there differ.
std::vector<std::pair<int, int>> SplitEdgesOfOctant(int labels, int octant) {
  std::vector<std::pair<int, int>> edges;
  for (int axis = 0; axis < 3; ++axis) {
    const int b = (axis + 1) % 3;
    const int c = (axis + 2) % 3;
    if (IsInside(labels, octant, b) != IsInside(labels, octant, c)) {
      edges.emplace_back(axis, octant >> axis & 1);
    }
  }
  return edges;
}

// The octant that a polygon is joined to along an edge: the next one around
// the edge with a polygon there, going through the outside face.
int Joined(int labels, int octant, int axis) {
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  int current = octant;
  int through = IsInside(labels, octant, b) ? c : b;
  do {
    current ^= 1 << through;
    through = through == b ? c : b;
    // All faces passed are outside, so the first inside face ends the walk.
  } while (!IsInside(labels, current, through));
  return current;
}

TEST(CornerUmbrellas, QuarterFacesOfNeighborsAgree) {
  for (int octant = 0; octant < 8; ++octant) {
    EXPECT_EQ(std::popcount(QuarterFacesOfOctant(octant)), 3);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(QuarterFace(octant, axis),
                QuarterFace(octant ^ 1 << axis, axis));
    }
  }
}

TEST(CornerUmbrellas, QuarterFaceTableTakesTheFacesAtTheCorner) {
  for (int octant = 0; octant < 8; ++octant) {
    for (int labels = 0; labels < 64; ++labels) {
      for (int axis = 0; axis < 3; ++axis) {
        // Octants on the - side touch the corner with their + faces.
        const int face = 2 * axis + (octant >> axis & 1 ? 0 : 1);
        EXPECT_EQ(
            kQuarterFaceTable[octant][labels] >> QuarterFace(octant, axis) & 1,
            labels >> face & 1);
      }
      EXPECT_EQ(
          kQuarterFaceTable[octant][labels] & ~QuarterFacesOfOctant(octant), 0);
    }
  }
}

TEST(CornerUmbrellas, AllLabellingsGiveTheCyclesOfJoinedPolygons) {
  for (int labels = 0; labels < 4096; ++labels) {
    const CornerUmbrellas& umbrellas = kCornerUmbrellaTable[labels];
    for (int octant = 0; octant < 8; ++octant) {
      const auto edges = SplitEdgesOfOctant(labels, octant);
      if (edges.empty()) {
        EXPECT_EQ(umbrellas.of_octant[octant], 0);
        continue;
      }
      ASSERT_EQ(edges.size(), 2);
      // Walk the cycle: leave each polygon along the edge not come by.
      unsigned cycle = 0;
      int current = octant;
      std::pair<int, int> edge = edges[0];
      do {
        cycle |= 1u << current;
        const int next = Joined(labels, current, edge.first);
        // Joining is mutual.
        ASSERT_EQ(Joined(labels, next, edge.first), current);
        const auto next_edges = SplitEdgesOfOctant(labels, next);
        ASSERT_EQ(next_edges.size(), 2);
        edge = next_edges[0] == edge ? next_edges[1] : next_edges[0];
        current = next;
      } while (current != octant || edge != edges[0]);
      EXPECT_EQ(umbrellas.of_octant[octant], cycle)
          << "labels " << labels << " octant " << octant;
      EXPECT_GE(std::popcount(cycle), 2);
    }
  }
}

TEST(CornerUmbrellas, FlagsEdgesWithFourPolygons) {
  for (int labels = 0; labels < 4096; ++labels) {
    bool expected = false;
    for (int axis = 0; axis < 3; ++axis) {
      for (int sign = 0; sign < 2; ++sign) {
        int num_polygons = 0;
        for (int octant = 0; octant < 8; ++octant) {
          for (const auto& edge : SplitEdgesOfOctant(labels, octant)) {
            num_polygons += edge == std::pair(axis, sign);
          }
        }
        EXPECT_TRUE(num_polygons == 0 || num_polygons == 2 ||
                    num_polygons == 4);
        expected |= num_polygons == 4;
      }
    }
    EXPECT_EQ(kCornerUmbrellaTable[labels].has_four_polygon_edge, expected);
  }
}

}  // namespace
}  // namespace octacut
