// A parallel loop over the voxels of a grid.
#pragma once

#include "core/base/parallel.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

// Calls body(index, code) once for each voxel, those of a brick one after the
// other; as ParallelFor does, and with its rules for what a body may write.
template <typename Body>
void ParallelForVoxels(const Context& context,
                       const VoxelGrid& grid,
                       const Body& body) {
  constexpr size_t kBricksAtOnce = 64;
  ParallelFor(context,
              grid.Bricks().size(),
              kBricksAtOnce,
              [&](size_t begin, size_t end) {
                grid.ForEachInBricks(begin, end, body);
              });
}

}  // namespace octacut
