// What is known of a final mesh without ground truth: how it fills the
// silhouettes.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/scene/scene.h"
#include "core/verdict/silhouette_check.h"
#include "core/views/view_set.h"

namespace octacut {

// What a mesh was made from. All must outlive its use.
struct JudgedScene {
  const std::vector<View>& given;
  const std::vector<View>& repaired;  // the same views, masks without gaps
  const ViewSet&
      views;  // of `repaired`, in the poses that the mesh was made in
  const BoundingCube& cube;
};

struct JudgeOptions {
  // Pixels of the photographs by which masks may be too small.
  double mask_tolerance = 0;
  // Pixels of the views by which they have been found to be too large.
  double border_shift = 0;
};

struct MeshVerdict {
  MaskCheck given_masks;
  MaskCheck repaired_masks;
  // One a view: pixels of the repaired masks that are missed for the sake of
  // components that were removed for being small.
  std::vector<size_t> removed_pixels;
  double silhouette_seconds = 0;
};

// `mesh`, closed, and the components `removed` from it in world coordinates.
// Throws as RayScene does.
MeshVerdict JudgeMesh(const IndexedMesh& mesh,
                      const IndexedMesh& removed,
                      const JudgedScene& scene,
                      const JudgeOptions& options,
                      const Context& context);

}  // namespace octacut
