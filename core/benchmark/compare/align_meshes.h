// Brings a mesh into the frame of a reference.
#pragma once

#include <cstdint>

#include "core/base/context.h"
#include "core/benchmark/compare/reference_filter.h"
#include "core/benchmark/compare/surface_icp.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/similarity.h"

namespace octacut {

// Iterations and tolerance are fixed, so that all figures of docs/accuracy.md
// mean the same.
struct AlignMeshesOptions {
  int64_t num_samples = 20000;  // on each surface
  static constexpr int kMaxIterations = 60;
  bool estimate_scale = true;
  // Ends when no point of the mesh moves further in an iteration; fraction of
  // the reference's size.
  static constexpr double kTolerance = 1e-6;
  // Looks for rotation, scale and position first: the mesh may be anywhere.
  bool global_search = false;

  // Throws OptionError that names the field as alignment.<field>.
  void Check() const;
};

struct MeshAlignment {
  Similarity3d reference_from_mesh;
  int num_iterations = 0;
  bool converged = false;
  // Root mean square of the pairs' distances, weighted by the loss, in the
  // reference's units: before (after the search, where there was one) and with
  // reference_from_mesh.
  double rms_before = 0;
  double rms_after = 0;
  // Mean over both directions of the median distance to the other surface.
  double median_after = 0;
  // The share of the pairs that the loss does not reject, in the direction in
  // which it is less.
  double inliers = 0;
  // Whether the search has found another place that fits about as well: the
  // shape is symmetric, or the solution doubtful.
  bool is_ambiguous = false;
};

// SurfaceIcp from where the mesh is, or from what FindGlobalAlignment has
// found. Directions that the shape leaves open (a sphere's rotation) stay as
// they are. Deterministic for any number of threads. Warns when it does not
// converge, when the solution is ambiguous, and when the surfaces stay so far
// apart that they hardly are of the same object; throws InputError for the last
// after a search, and when nothing of the reference counts or neither has
// faces.
MeshAlignment AlignMeshes(const IndexedMesh& mesh,
                          const IndexedMesh& reference,
                          const AlignMeshesOptions& options,
                          const Context& context,
                          const ReferenceFilter& filter = {});

// The same, with scenes that the caller has already.
MeshAlignment AlignMeshes(const MeshWithScene& mesh,
                          const MeshWithScene& reference,
                          const AlignMeshesOptions& options,
                          const Context& context,
                          const ReferenceFilter& filter = {});

}  // namespace octacut
