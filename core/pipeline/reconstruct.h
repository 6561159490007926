// Hierarchical volumetric multi-view stereo [HK06]: views in, closed manifold
// mesh out.
#pragma once

#include <cstddef>
#include <functional>

#include "core/base/context.h"
#include "core/mesh/audit.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/surface_mesh.h"
#include "core/pipeline/build_mesh.h"
#include "core/pipeline/options.h"
#include "core/pipeline/summary.h"
#include "core/scene/region.h"
#include "core/scene/scene.h"
#include "core/verdict/judge_mesh.h"

namespace octacut {

struct Reconstruction {
  SurfaceMesh mesh;  // world coordinates, with normals and colours
  // The audit of ToIndexedMesh(mesh), as it is written; CheckAudit(audit) has
  // passed.
  MeshAudit audit;
  MeshVerdict verdict;
  ReconstructionSummary summary;
};

// Throws InputError when the scene cannot be reconstructed (no hull, a view
// without image, a surface that vanishes), InvariantError when the mesh is
// not what is promised.
Reconstruction Reconstruct(const Scene& scene,
                           const Region& region,
                           const ReconstructionOptions& options,
                           const Context& context,
                           const LevelObserver& observer = nullptr);

// Bytes that Reconstruct will need at its peak besides the scene, roughly: the
// silhouettes tell how large the surface in the cube is.
size_t EstimateReconstructionBytes(const Scene& scene,
                                   const BoundingCube& cube,
                                   const ReconstructionOptions& options,
                                   const Context& context);

}  // namespace octacut
