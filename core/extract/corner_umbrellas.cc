#include "core/extract/corner_umbrellas.h"

namespace octacut {
namespace {

constexpr void Join(int a, int b, std::array<OctantMask, 8>& umbrellas) {
  const OctantMask joined = umbrellas[a] | umbrellas[b];
  for (int octant = 0; octant < 8; ++octant) {
    if (joined >> octant & 1) {
      umbrellas[octant] = joined;
    }
  }
}

// Joins the polygons around the grid edge that leaves the corner along `axis`
// to the side `sign` (0: -, 1: +). Returns how many there are.
constexpr int JoinAroundEdge(QuarterFaceLabels labels,
                             int axis,
                             int sign,
                             std::array<OctantMask, 8>& umbrellas) {
  const int b = NextAxis(axis);
  const int c = NextAxis(b);
  const int base = sign << axis;
  const int ring[4] = {
      base, base | 1 << b, base | 1 << b | 1 << c, base | 1 << c};
  // inside[i]: the quarter face between ring octants i and i + 1.
  bool inside[4] = {};
  for (int i = 0; i < 4; ++i) {
    inside[i] = labels >> QuarterFace(ring[i], i % 2 == 0 ? b : c) & 1;
  }
  int split[4] = {};
  int num_split = 0;
  for (int i = 0; i < 4; ++i) {
    if (inside[i] != inside[(i + 3) % 4]) {
      split[num_split++] = ring[i];
    }
  }
  if (num_split == 2) {
    Join(split[0], split[1], umbrellas);
  } else if (num_split == 4) {
    for (int i = 0; i < 4; ++i) {
      if (!inside[i]) {
        Join(ring[i], ring[(i + 1) % 4], umbrellas);
      }
    }
  }
  return num_split;
}

constexpr CornerUmbrellas FindUmbrellas(QuarterFaceLabels labels) {
  CornerUmbrellas result{};
  for (int octant = 0; octant < 8; ++octant) {
    const QuarterFaceLabels faces = QuarterFacesOfOctant(octant);
    const bool cut = (labels & faces) != 0 && (labels & faces) != faces;
    result.of_octant[octant] = cut ? OctantMask(1u << octant) : OctantMask(0);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (int sign = 0; sign < 2; ++sign) {
      const int num_polygons =
          JoinAroundEdge(labels, axis, sign, result.of_octant);
      result.has_four_polygon_edge |= num_polygons == 4;
    }
  }
  return result;
}

constexpr std::array<CornerUmbrellas, 4096> FindAllUmbrellas() {
  std::array<CornerUmbrellas, 4096> table{};
  for (int labels = 0; labels < 4096; ++labels) {
    table[labels] = FindUmbrellas(QuarterFaceLabels(labels));
  }
  return table;
}

constexpr std::array<std::array<QuarterFaceLabels, 64>, 8> FindQuarterFaces() {
  std::array<std::array<QuarterFaceLabels, 64>, 8> table{};
  for (int octant = 0; octant < 8; ++octant) {
    for (int labels = 0; labels < 64; ++labels) {
      for (int axis = 0; axis < 3; ++axis) {
        if (labels >> FaceAtCorner(7 ^ octant, axis) & 1) {
          table[octant][labels] |= 1u << QuarterFace(octant, axis);
        }
      }
    }
  }
  return table;
}

}  // namespace

constexpr std::array<CornerUmbrellas, 4096> kCornerUmbrellaTable =
    FindAllUmbrellas();

constexpr std::array<std::array<QuarterFaceLabels, 64>, 8> kQuarterFaceTable =
    FindQuarterFaces();

}  // namespace octacut
