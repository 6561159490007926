// Finds what the polygons would draw a second time or across each other, so
// that every edge of the mesh belongs to two triangles and none intersect. For
// core/extract alone.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/extract/cut_voxels.h"
#include "core/extract/loop_choices.h"
#include "core/extract/umbrella_vertices.h"

namespace octacut {

// A vertex by the middle of a grid edge. Four polygons meet in the edge, in
// two pairs, and both pairs have the same vertices at both ends: one pair is
// joined through this vertex instead.
struct EdgeVertex {
  CutVoxels::Index number;  // of the voxel
  uint8_t from;             // corner of the voxel's loop that it follows
  uint32_t id;              // among the edge vertices
};

struct SharedEdges {
  // For each cut voxel, bit i: loop i has to be a fan around the centre of the
  // voxel, which has no chord and lies in no face.
  std::vector<uint8_t> fans;
  // Two of each id, sorted by voxel and corner.
  std::vector<EdgeVertex> edge_vertices;
  std::vector<Eigen::Vector3d> edge_positions;  // by id
  std::vector<OctantMask> edge_octants;         // by id
  size_t num_four_polygon_edges = 0;
  size_t num_fans = 0;  // loops that are fans for their chords
};

// If several polygons draw a chord between the same two vertices, or in the
// same face, the first one keeps it; none keeps one that is an edge of another
// polygon.
SharedEdges FindSharedEdges(const CutVoxels& cut,
                            const UmbrellaVertices& umbrellas,
                            const LoopChoices& choices,
                            const BoundingCube& cube,
                            const Context& context);

}  // namespace octacut
