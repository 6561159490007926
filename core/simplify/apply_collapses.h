// A mesh after some of its collapses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/indexed_mesh.h"
#include "core/mesh/surface_mesh.h"
#include "core/simplify/collapse_sequence.h"

namespace octacut {

struct CollapsedMesh {
  // Positions, colours and confidence are those of the vertices that are left;
  // without normals, which no longer hold.
  IndexedMesh mesh;
  // Number of each triangle in the full mesh, where it may have had other
  // corners.
  std::vector<uint32_t> source_triangles;
  // For each vertex of the full mesh the one of `mesh` that it was moved onto.
  std::vector<uint32_t> owners;
  // For each vertex of the full mesh that was moved the number of its collapse,
  // from 1; 0 for those that are left.
  std::vector<uint32_t> moved_at;
};

class CollapseReplay {
 public:
  // Finds collapses down to `num_triangles`. `full` must outlive the object and
  // be a closed 2-manifold.
  CollapseReplay(const IndexedMesh& full,
                 size_t num_triangles,
                 const Context& context);

  const IndexedMesh& Full() const { return full_; }
  // Triangles left after all collapses.
  size_t LeastTriangles() const;

  // Makes the collapses in their order until at most `num_triangles` are left,
  // but none that moves a vertex marked in `held` (empty: none are; or one for
  // each vertex), and none that is not allowed any more because of that.
  CollapsedMesh Run(size_t num_triangles,
                    const std::vector<uint8_t>& held) const;

 private:
  const IndexedMesh& full_;
  SurfaceMesh surface_;
  std::vector<Collapse> collapses_;
};

}  // namespace octacut
