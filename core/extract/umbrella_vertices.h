// One vertex for each umbrella of polygons around a grid corner. For
// core/extract alone.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/extract/corner_umbrellas.h"
#include "core/extract/cut_voxels.h"
#include "core/extract/split_loops.h"
#include "core/scene/scene.h"

namespace octacut {

// Bricks handled as one unit of parallel work.
inline constexpr size_t kBricksPerChunk = 256;

// Every corner of a loop has a slot; those of a cut voxel lie one after
// another, by ascending corner.
struct UmbrellaVertices {
  std::vector<uint32_t> first_slot;  // of every cut voxel
  // For each cut voxel, whether four polygons meet in a grid edge at one of its
  // loops' corners.
  std::vector<uint8_t> near_four_polygon_edge;
  std::vector<OctantMask> umbrellas;       // of every slot
  std::vector<uint32_t> vertices;          // of every slot
  std::vector<Eigen::Vector3d> positions;  // of every vertex: its grid corner
  std::vector<OctantMask> octants;         // of every vertex: its umbrella
  size_t num_extra = 0;  // vertices beyond the first at their corner

  size_t Slot(CutVoxels::Index number, FaceLabels labels, int corner) const {
    const unsigned below = (1u << corner) - 1;
    return first_slot[number] +
           std::popcount(kSplitLoopTable[labels].corner_mask & below);
  }
  OctantMask Umbrella(CutVoxels::Index number,
                      FaceLabels labels,
                      int corner) const {
    return umbrellas[Slot(number, labels, corner)];
  }
};

// Vertices are numbered by the first cut voxel of their umbrella, then by its
// corner. Throws InputError when the labels do not bound a volume: neighbours
// disagree about a face, or the surface ends at the border of the crust.
UmbrellaVertices FindUmbrellaVertices(const CutVoxels& cut,
                                      const BoundingCube& cube,
                                      const Context& context);

}  // namespace octacut
