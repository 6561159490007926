// Where to start aligning two surfaces that are in frames of their own.
#pragma once

#include "core/base/context.h"
#include "core/benchmark/compare/surface_icp.h"

namespace octacut {

struct GlobalAlignment {
  Similarity3d reference_from_mesh;
  // Residuals of the best rotation and of the best one that leads elsewhere: in
  // the reference's units, medians as in IcpResidual. Alike for symmetric
  // shapes.
  double median = 0;
  double next_median = 0;
};

// Tries rotations spread evenly over all (super-Fibonacci spirals: Alexa, CVPR
// 2022), with the median centre and, if `estimate_scale`, the scale from the
// median distances to it, and runs ICP from each: briefly from all, longer from
// those with the least medians. Deterministic for any number of threads.
GlobalAlignment FindGlobalAlignment(const MeshWithScene& mesh,
                                    const MeshWithScene& reference,
                                    const ReferenceFilter& filter,
                                    bool estimate_scale,
                                    const Context& context);

}  // namespace octacut
