// Precision, recall and F-score as Tanks and Temples measures them.
//
// Sources: A. Knapitsch, J. Park, Q.-Y. Zhou, V. Koltun, "Tanks and temples:
// benchmarking large-scale scene reconstruction", ACM Transactions on Graphics
// 36 (2017); the evaluation in the benchmark's toolbox
// (isl-org/TanksAndTemples, python_toolbox/evaluation: run.py, registration.py,
// evaluation.py).
//   alignment: from a rough alignment, three runs of ICP between points, with
//              scale: pairs up to 80 tau apart in cells of tau, up to 20 tau in
//              cells of tau / 2, up to 2 tau in at most some 4 million points
//   crop:      both clouds by the prism of the scene, after alignment
//   sampling:  means of the points in cells of tau / 2
//   figures:   the fractions of the points of each cloud that are closer than
//              tau to a point of the other
#pragma once

#include "core/base/context.h"
#include "core/benchmark/protocols/crop_polygon.h"
#include "core/benchmark/protocols/protocol_result.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// `mesh` is roughly aligned. Meshes are sampled in cells of tau / 2; the
// toolbox would take their vertices alone. One score; figures of the last
// alignment ("inlier fraction" within two tau, "inlier RMSE"),
// "points" and "reference points" that count. Warns where fewer than half are
// aligned. Throws InputError where the crop leaves nothing of either.
ProtocolResult MeasureTanksAndTemples(const IndexedMesh& mesh,
                                      const IndexedMesh& reference,
                                      const CropPolygon& crop,
                                      double tau,
                                      const Context& context);

}  // namespace octacut
