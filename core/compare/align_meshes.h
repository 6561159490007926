// Brings a mesh into the frame of a reference that it already nearly agrees
// with: the iterative closest point method over both surfaces.
#pragma once

#include <cstdint>

#include "core/base/context.h"
#include "core/compare/reference_filter.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/similarity.h"
#include "core/raycast/ray_scene.h"

namespace octacut {

// Iterations, kept fraction and tolerance are fixed, so that all figures of
// docs/accuracy.md mean the same.
struct AlignMeshesOptions {
  int64_t num_samples = 20000;  // on each surface
  int max_iterations = 60;
  // Of the pairs of each direction those that are closest; the others may be
  // parts that one surface lacks.
  double kept_fraction = 0.9;
  bool estimate_scale = true;
  // Ends when no point of the mesh moves further in an iteration; fraction of
  // the reference's size.
  double tolerance = 1e-6;

  // Throws OptionError that names the field as alignment.<field>.
  void Check() const;
};

struct MeshAlignment {
  Similarity3d reference_from_mesh;
  int num_iterations = 0;
  bool converged = false;
  // Root mean square of the kept pairs' distances, in the reference's units:
  // before and with reference_from_mesh.
  double rms_before = 0;
  double rms_after = 0;
};

// Pairs each sample of either surface with the closest point of the other and
// solves for the similarity that minimises the distances along the
// reference's normals (Chen & Medioni 1992, linearised; trimmed as Chetverikov
// et al. 2002). Using both directions keeps the scale from collapsing.
// Directions that the shape leaves open (a sphere's rotation) stay as they
// are. Of all iterations the best one is returned. Deterministic for any
// number of threads. Throws InputError when nothing of the reference counts.
MeshAlignment AlignMeshes(const IndexedMesh& mesh,
                          const IndexedMesh& reference,
                          const AlignMeshesOptions& options,
                          const Context& context,
                          const ReferenceFilter& filter = {});

// The same, with scenes that the caller has already.
MeshAlignment AlignMeshes(const IndexedMesh& mesh,
                          const RayScene& mesh_scene,
                          const IndexedMesh& reference,
                          const RayScene& reference_scene,
                          const AlignMeshesOptions& options,
                          const Context& context,
                          const ReferenceFilter& filter = {});

}  // namespace octacut
