// Where a mesh stands on the plate of a printer.
#pragma once

#include <Eigen/Core>

#include "core/mesh/indexed_mesh.h"
#include "core/mesh/similarity.h"

namespace octacut {

// The similarity that multiplies lengths by `scale`, turns `up` (not zero, in
// the frame of the mesh) into +z by the least rotation, and puts the lowest
// point of the mesh on z = 0 and the middle of its extents in x and y on the
// z-axis. Vertices of no triangle count as well.
Similarity3d PlaceOnPlate(const IndexedMesh& mesh,
                          double scale,
                          const Eigen::Vector3d& up);

}  // namespace octacut
