// Hierarchical volumetric multi-view stereo [HK06]: views in, closed manifold
// mesh out.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/extract/extract_surface.h"
#include "core/handles/remove_handles.h"
#include "core/mesh/audit.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/surface_mesh.h"
#include "core/pipeline/options.h"
#include "core/refine/refine_surface.h"
#include "core/scene/region.h"
#include "core/scene/scene.h"
#include "core/verdict/judge_mesh.h"
#include "core/views/border_edges.h"

namespace octacut {

struct LevelSummary {
  int level = 0;
  int resolution = 0;
  size_t num_crust_voxels = 0;
  size_t num_medial_voxels = 0;
  size_t num_graph_nodes = 0;
  size_t num_cut_voxels = 0;
  double cut_cost = 0;
  ConsistencySummary consistency;
  // Of the cut voxels, the share where photographs decided.
  double decided_share = 0;
  int num_grow_rounds = 0;
  // Of the first level: rounds that asked back what silhouettes miss.
  int num_cover_rounds = 0;
  // The share of the silhouettes' sure samples that a cut left uncovered, at
  // most, and after the last one; voxels that had to be inside for them.
  double missed_before = 0;
  double missed_after = 0;
  size_t num_cover_voxels = 0;
  size_t num_border_voxels = 0;  // cut voxels that touch the crust's border
  double crust_seconds = 0;
  double visibility_seconds = 0;
  double consistency_seconds = 0;
  double cut_seconds = 0;
  double cover_seconds = 0;
};

struct ReconstructionSummary {
  size_t num_false_gaps = 0;  // in masks, filled
  std::optional<BorderEdges> border_edges;
  VisualHullSummary hull;
  InsideEvidenceSummary evidence;
  std::vector<LevelSummary> levels;
  ExtractSurfaceSummary extraction;
  size_t num_removed_components = 0;
  RemoveHandlesSummary handles;
  std::optional<RefineSummary> refinement;  // where options.refine says so
  double prepare_seconds = 0;
  double hull_seconds = 0;
  double evidence_seconds = 0;
  double meshing_seconds = 0;
  double coloring_seconds = 0;
};

struct Reconstruction {
  SurfaceMesh mesh;  // world coordinates, with normals and colours
  // Of ToIndexedMesh(mesh), as it is written; CheckAudit(audit) has passed.
  MeshAudit audit;
  MeshVerdict verdict;
  ReconstructionSummary summary;
};

// Receives the hull (level -1) and every level's surface, before smoothing.
using LevelObserver = std::function<void(int level, const IndexedMesh& mesh)>;

// Throws InputError when the scene cannot be reconstructed (no hull, a view
// without image, a surface that vanishes), InvariantError when the mesh is
// not what is promised.
Reconstruction Reconstruct(const Scene& scene,
                           const Region& region,
                           const ReconstructionOptions& options,
                           const Context& context,
                           const LevelObserver& observer = nullptr);

struct HullReconstruction {
  SurfaceMesh mesh;  // world coordinates, with normals
  MeshAudit audit;   // as that of a Reconstruction
  MeshVerdict verdict;
};

// The visual hull alone, from silhouettes (images are not needed). Throws as
// Reconstruct does.
HullReconstruction ReconstructHull(const Scene& scene,
                                   const Region& region,
                                   const HullReconstructionOptions& options,
                                   const Context& context);

// Bytes that Reconstruct will need at its peak besides the scene, roughly.
size_t EstimateReconstructionBytes(const Scene& scene,
                                   const ReconstructionOptions& options,
                                   const Context& context);

}  // namespace octacut
