// How the polygons around a grid corner join into umbrellas.
//
// Eight octants (see cube_topology.h) and twelve quarter faces meet in a grid
// corner; quarter face 4 a + (o_b | 2 o_c), with b and c the axes after a,
// separates the two octants that differ along axis a alone. An octant whose
// three quarter faces are not all alike has one polygon at the corner. Along
// each of the six grid edges at the corner four quarter faces form a ring:
//  - labels change twice around the ring: the two polygons there are joined;
//  - labels alternate in/out/in/out: four polygons; those that face each
//    other across an outside face are joined, never across an inside face.
// So each polygon is joined along both of its edges, the rule depends on the
// ring alone and is the same at both ends of the edge, and the polygons of a
// corner fall into cycles: the umbrellas, one vertex each.
#pragma once

#include <array>
#include <cstdint>

#include "core/extract/cube_topology.h"
#include "core/grid/face.h"

namespace octacut {

// Bit q: quarter face q is inside.
using QuarterFaceLabels = uint16_t;

// Octants of an umbrella: bit o set = the polygon of octant o belongs to it.
using OctantMask = uint8_t;

struct CornerUmbrellas {
  // Umbrella of the polygon of each octant; 0 where an octant has none.
  std::array<OctantMask, 8> of_octant;
  // Four polygons meet in some grid edge at the corner.
  bool has_four_polygon_edge = false;
};

// One element for each of the 2^12 labellings of a corner.
extern const std::array<CornerUmbrellas, 4096> kCornerUmbrellaTable;

// The quarter face of an octant across `axis`.
inline constexpr int QuarterFace(int octant, int axis) {
  const int b = NextAxis(axis);
  const int c = NextAxis(b);
  return 4 * axis + (octant >> b & 1) + 2 * (octant >> c & 1);
}

// The three quarter faces of an octant.
inline constexpr QuarterFaceLabels QuarterFacesOfOctant(int octant) {
  return QuarterFaceLabels(1u << QuarterFace(octant, 0) |
                           1u << QuarterFace(octant, 1) |
                           1u << QuarterFace(octant, 2));
}

// The quarter faces that a voxel in `octant` labels inside, for each of its
// 2^6 labellings.
extern const std::array<std::array<QuarterFaceLabels, 64>, 8> kQuarterFaceTable;

}  // namespace octacut
