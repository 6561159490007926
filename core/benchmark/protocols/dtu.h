// Accuracy and completeness as the DTU robot image data set measures them.
//
// Sources: R. Jensen, A. Dahl, G. Vogiatzis, E. Tola, H. Aanaes, "Large scale
// multi-view stereopsis evaluation", CVPR 2014; the data set's MATLAB code
// (SampleSet.zip, Matlab evaluation code: BaseEvalMain_web.m,
// PointCompareMain.m, MaxDistCP.m, ComputeStat_web.m).
//   alignment: none: the given cameras are the frame, in millimetres
//   sampling:  the points of the mesh in a random order, without those within
//              0.2 mm of an earlier one; the reference as it is (its files are
//              thinned already)
//   crop:      points of the mesh in the observability mask; points of the
//              reference above the ground plane; distances of 20 mm and more,
//              and points outside the bounding box, are left out as outliers
//   figures:   accuracy and completeness: mean and median distances to the
//              reference and from it; overall: the mean of both means
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/protocols/protocol_result.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// ObsMask<scan>_10.mat: the cells that the cameras observe.
struct ObservabilityMask {
  std::array<size_t, 3> size = {};
  std::vector<uint8_t> cells;                         // x fastest
  Eigen::Vector3d box_min = Eigen::Vector3d::Zero();  // BB
  Eigen::Vector3d box_max = Eigen::Vector3d::Zero();
  double cell_size = 0;  // Res

  // Cell (0, 0, 0) has its centre at box_min.
  bool Contains(const Eigen::Vector3d& point) const;
};

// `plane`, of Plane<scan>.mat: points with plane . (x, y, z, 1) > 0 are above
// the ground. Meshes are sampled at 0.2 mm. Figures: "accuracy", "accuracy
// median", "completeness", "completeness median", "overall", "points",
// "reference points" that count. Throws InputError where nothing does.
ProtocolResult MeasureDtu(const IndexedMesh& mesh,
                          const IndexedMesh& reference,
                          const ObservabilityMask& mask,
                          const Eigen::Vector4d& plane,
                          const Context& context);

}  // namespace octacut
