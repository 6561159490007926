// Bounded smoothing of a closed mesh [HK06 section 5, step 9 of the method].
#pragma once

#include <cstddef>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct SmoothOptions {
  int iterations = 3;
  // V <- V + lambda * Laplacian(V), with the uniform umbrella operator: mean of
  // the neighbours less the vertex. Half way; iterations say how much.
  double lambda = 0.5;
  // With mu <= -lambda, every iteration is followed by one of V <- V + mu *
  // Laplacian(V), which gives back the volume that smoothing takes (Taubin,
  // SIGGRAPH 1995) but smooths less per iteration. 0: none.
  double taubin_mu = 0;
  // How far a vertex may come from where it began, in voxels: the cut is known
  // to one. docs/experiments/smoothing.md.
  double max_displacement = 1;
  // Least height of a triangle over its longest edge, in voxels: vertices of
  // triangles that end up thinner, or intersect others, are moved back towards
  // where they began.
  double min_height = 0.02;

  void Check() const;
};

struct SmoothSummary {
  double max_displacement = 0;   // in voxels
  double mean_displacement = 0;  // in voxels
  size_t num_bounded = 0;        // vertices at the bound
  size_t num_withdrawn = 0;      // vertices moved back
  size_t num_thin = 0;           // triangles that were too thin from the first
};

struct SmoothedSurface {
  IndexedMesh mesh;  // without normals: they no longer hold
  SmoothSummary summary;
};

// `voxel_size` is the unit of the options, in world units. All vertices of an
// iteration move at once (Jacobi). The mesh is to be closed and oriented;
// vertices without triangles stay. No triangles intersect but those that did
// before.
SmoothedSurface SmoothSurface(IndexedMesh mesh,
                              double voxel_size,
                              const SmoothOptions& options,
                              const Context& context);

}  // namespace octacut
