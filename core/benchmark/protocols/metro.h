// Distances between two surfaces as the program Metro measures them.
//
// Source: P. Cignoni, C. Rocchini, R. Scopigno, "Metro: measuring error on
// simplified surfaces", Computer Graphics Forum 17 (1998); number of samples as
// in Metro 4.07 (vcglib, apps/metro).
//   alignment: none        crop: none
//   sampling:  10 points for each triangle of the larger mesh, on both meshes,
//              evenly by area; maxima include the vertices
//   figures:   for both directions the mean, root mean square and maximum of
//              the distances from the points of one surface to the closest
//              point of the other; the larger maximum is the Hausdorff distance
#pragma once

#include "core/base/context.h"
#include "core/benchmark/protocols/protocol_result.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// Either may be a cloud, whose points are then the samples. Metro counts its
// samples of vertices and edges in the means as well, which weights small
// triangles more; here they are the integrals over the surfaces that the paper
// defines.
// Figures: "forward mean", "forward rms", "forward max" (from the mesh),
// "backward ..." (from the reference), "Hausdorff", "samples" of both surfaces.
ProtocolResult MeasureMetro(const IndexedMesh& mesh,
                            const IndexedMesh& reference,
                            const Context& context);

}  // namespace octacut
