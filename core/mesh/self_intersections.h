// Pairs of triangles of one mesh that intersect.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct SelfIntersections {
  size_t num_pairs = 0;
  size_t num_triangles = 0;  // that are in at least one pair
  // Triangles without area or with coordinates that are not finite: left out.
  size_t num_left_out = 0;
  // The first pairs found, the smaller index first; sorted.
  std::vector<std::array<uint32_t, 2>> examples;
};

// What counts as intersecting says triangle_intersection.h: joins by position
// do not, so umbrellas that merely touch at a corner or along an edge are no
// intersection; everything else that two triangles have in common is. Decided
// exactly. Time grows with the triangles and the pairs of overlapping boxes;
// the same for any number of threads. Throws InputError for an index out of
// range.
SelfIntersections FindSelfIntersections(const IndexedMesh& mesh,
                                        const Context& context,
                                        size_t max_examples = 0);

// All pairs, sorted, in which at least one triangle has a mark (one for each
// triangle, not 0): what is new where only marked ones have moved.
std::vector<std::array<uint32_t, 2>> FindIntersectionsOfMarked(
    const IndexedMesh& mesh,
    const std::vector<uint8_t>& marked,
    const Context& context);

}  // namespace octacut
