// How far each vertex of a mesh can be relied upon, by what has been measured
// there.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/verdict/surface_evidence.h"

namespace octacut {

// Pixels by which each point may lie elsewhere, roughly: the least of what
// photographs and silhouettes leave open there, and of what is known of points
// nearby, which tell less the farther they are away.
std::vector<float> ExpectedErrors(const SurfaceEvidence& evidence);

// 1 / (1 + expected error), one per vertex, 0 .. 1: a half where the surface is
// known to a pixel. Of the errors of the points around a vertex, weighted by
// 1 / (1 + squared distance in pixels). `mesh`, in unit coordinates, is that of
// the evidence.
std::vector<float> VertexConfidence(const IndexedMesh& mesh,
                                    const SurfaceEvidence& evidence,
                                    const Context& context);

}  // namespace octacut
