// Labellings of crusts for tests.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <random>
#include <vector>

#include "core/extract/position_vertices.h"
#include "core/grid/voxel_grid.h"
#include "core/mesh/audit.h"
#include "core/scene/scene.h"

namespace octacut {

struct LabelledCrust {
  VoxelGrid crust;
  std::vector<FaceLabels> labels;
};

// Whether the face on the lower side of voxel (x, y, z) along `axis` is
// inside.
using FaceIsInside = std::function<bool(int axis, int x, int y, int z)>;

// A dense block of voxels [low, low + size). `inside` is asked for faces with
// coordinates 0 .. size relative to `low`; `border` overrules it on the border
// of the block, so that the surface is closed.
LabelledCrust LabelBlock(int level,
                         const Eigen::Vector3i& low,
                         const Eigen::Vector3i& size,
                         bool border,
                         const FaceIsInside& inside);

// A block of side^3 voxels at a random place of level 4; faces are inside with
// a random probability.
LabelledCrust LabelRandomBlock(int side, bool border, std::mt19937& random);

// The voxels whose centre is less than two of their edges away from the
// surface of a signed distance (negative inside), in the unit cube; faces take
// the side of their centre.
LabelledCrust LabelShape(
    int level, const std::function<double(const Eigen::Vector3d&)>& distance);

double SphereDistance(const Eigen::Vector3d& point);  // radius 0.4
double TorusDistance(const Eigen::Vector3d& point);   // radii 0.27 and 0.12

// Pairs of triangles that intersect.
size_t NumIntersections(const IndexedMesh& mesh);

// Its surface with positioned vertices.
IndexedMesh Place(const LabelledCrust& labelled, const BoundingCube& cube);

// The cube whose voxels of `level` have unit edges.
BoundingCube UnitVoxels(int level);
BoundingCube UnitCube();

// Closed, 2-manifold, oriented, without degenerate or duplicate triangles.
void ExpectClosedManifold(const MeshAudit& audit);

}  // namespace octacut
