// Accuracy and completeness as the Middlebury multi-view benchmark measures
// them.
//
// Source: S. Seitz, B. Curless, J. Diebel, D. Scharstein, R. Szeliski, "A
// comparison and evaluation of multi-view stereo reconstruction algorithms",
// CVPR 2006, section 5 and figure 4.
//   alignment: none: the cameras of the benchmark give the frame
//   crop:      vertices of the mesh that are closest to a surface that fills
//              the holes of the ground truth do not count for accuracy
//   sampling:  the vertices of both meshes
//   figures:   accuracy, the distance to the ground truth that 90 % of the
//              mesh's vertices keep; completeness, the fraction of the ground
//              truth's vertices at the tolerance or less from the mesh
//              (1.25 mm in the benchmark's tables)
#pragma once

#include "core/base/context.h"
#include "core/benchmark/protocols/protocol_result.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// Whether the ground truth has holes, which the protocol wants filled. A cloud
// has none.
bool NeedsHoleFiller(const IndexedMesh& reference, const Context& context);

// `hole_filler` is null where there are no holes. Either mesh may be a cloud.
// Figures: "accuracy", "completeness", "vertices", "vertices at holes". Throws
// InputError where all vertices are at holes.
ProtocolResult MeasureMiddlebury(const IndexedMesh& mesh,
                                 const IndexedMesh& reference,
                                 const IndexedMesh* hole_filler,
                                 double tolerance,
                                 const Context& context);

}  // namespace octacut
