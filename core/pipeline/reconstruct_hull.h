// The visual hull alone, as a mesh.
#pragma once

#include "core/base/context.h"
#include "core/hull/visual_hull.h"
#include "core/mesh/audit.h"
#include "core/mesh/surface_mesh.h"
#include "core/pipeline/finish_mesh.h"
#include "core/scene/region.h"
#include "core/scene/scene.h"
#include "core/verdict/judge_mesh.h"

namespace octacut {

struct HullReconstructionOptions {
  bool fill_false_gaps = true;  // as MaskOptions has it
  VisualHullOptions hull{.hull_level = 8};
  FinishOptions finish{.smoothing = {.iterations = 2}};
  void Check() const;
};

struct HullReconstruction {
  SurfaceMesh mesh;  // world coordinates, with normals
  MeshAudit audit;   // as that of a Reconstruction
  MeshVerdict verdict;
};

// From silhouettes; images are not needed. Throws InputError where the hull is
// empty, and as CheckScene does.
HullReconstruction ReconstructHull(const Scene& scene,
                                   const Region& region,
                                   const HullReconstructionOptions& options,
                                   const Context& context);

}  // namespace octacut
