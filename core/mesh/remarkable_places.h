// The few places of a surface where values of its vertices are largest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct RemarkablePlace {
  uint32_t vertex = 0;  // that of the largest value there
  double value = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit, or zero
};

// At most `count` vertices, the largest value first, each at least `distance`
// from those before it. Values that are not numbers do not count. `values` and
// `normals` are of the mesh's vertices; of equal values the lowest index.
std::vector<RemarkablePlace> FindRemarkablePlaces(
    const IndexedMesh& mesh,
    const std::vector<float>& values,
    const std::vector<Eigen::Vector3f>& normals,
    size_t count,
    double distance);

// Each vertex gets the mean of the values in its cell of a cubic grid, so that
// a single vertex makes no place; not a number in cells of fewer than
// `least_count` values, and where the vertex itself has none.
std::vector<float> CellMeans(const IndexedMesh& mesh,
                             const std::vector<float>& values,
                             double cell_edge,
                             size_t least_count);

}  // namespace octacut
