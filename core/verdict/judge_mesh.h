// What is known of a final mesh without ground truth: how it fills the
// silhouettes, what its surface rests on, and how far each vertex can be relied
// upon.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/refine/refine_options.h"
#include "core/scene/scene.h"
#include "core/verdict/silhouette_check.h"
#include "core/verdict/surface_support.h"
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
  // Pixels of the views by which the repaired masks have been found to be too
  // large.
  double border_shift = 0;
  // By which the borders of the given masks had been moved before, one per
  // view; or empty.
  std::vector<double> moved_inwards = {};
  // The level of the voxels in which the search began; 0 where there were none.
  int hull_level = 0;
  // How photographs are compared, as refinement does.
  RefineOptions refinement = {};
  bool confidence = false;  // of the vertices, wanted
};

struct MeshVerdict {
  MaskCheck given_masks;
  MaskCheck repaired_masks;
  // One per view: pixels of the repaired masks that are missed for the sake of
  // components that were removed for being small.
  std::vector<size_t> removed_pixels;
  // The missed pixels of the repaired masks that lie in parts thinner than
  // three voxels of the hull, roughly.
  size_t num_thin_pixels = 0;
  // As given.
  double border_shift = 0;
  int hull_level = 0;
  // None where views have no image.
  std::optional<SurfaceSupport> surface;
  // One per vertex, 0 .. 1; empty unless wanted and measured.
  std::vector<float> confidence;
  double silhouette_seconds = 0;
  double surface_seconds = 0;
};

// `mesh`, closed, and the components `removed` from it in world coordinates.
// Throws as RayScene does.
MeshVerdict JudgeMesh(const IndexedMesh& mesh,
                      const IndexedMesh& removed,
                      const JudgedScene& scene,
                      const JudgeOptions& options,
                      const Context& context);

}  // namespace octacut
