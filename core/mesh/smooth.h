// Bounded smoothing of a closed mesh [HK06 section 5, step 9 of the method].
#pragma once

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct SmoothOptions {
  int iterations = 3;
  // V <- V + lambda * Laplacian(V), with the uniform umbrella operator: mean of
  // the neighbours less the vertex. Half way; iterations say how much.
  static constexpr double kLambda = 0.5;
  // With mu <= -lambda, every iteration is followed by one of V <- V + mu *
  // Laplacian(V), which gives back the volume that smoothing takes (Taubin,
  // SIGGRAPH 1995) but smooths less per iteration. 0: none.
  double taubin_mu = 0;
  // How far a vertex may come from where it began, in voxels: the cut is known
  // to one. docs/experiments/smoothing.md.
  double max_displacement = 1;

  void Check() const;
};

// `voxel_size` is the unit of the options, in world units. All vertices of an
// iteration move at once (Jacobi). The mesh is to be closed and oriented;
// vertices without triangles stay. No triangles intersect but those that did
// before: vertices of those that would, and of triangles that end up lower than
// kMinTriangleHeight, are moved back towards where they began. Normals no
// longer hold: the result is without.
IndexedMesh SmoothSurface(IndexedMesh mesh,
                          double voxel_size,
                          const SmoothOptions& options,
                          const Context& context);

}  // namespace octacut
