// Accuracy and completeness as ETH3D measures them.
//
// Sources: T. Schoeps, J. Schoenberger, S. Galliani, T. Sattler, K. Schindler,
// M. Pollefeys, A. Geiger, "A multi-view stereo benchmark with high-resolution
// images and multi-camera videos", CVPR 2017; the benchmark's evaluation
// program (ETH3D/multi-view-evaluation: accuracy.cc, completeness.cc).
//   alignment: none: the given poses are the frame
//   crop:      none; what no laser beam has passed or hit is not judged
//   sampling:  the points as they are; fractions are taken within cells of
//              0.01 m and averaged over all cells, of two grids that are half
//              a cell apart
//   occlusion: a point in the beam of a scan point (radius 1.125 mm, growing by
//              0.011 degrees) is accurate where it is at the tolerance or less
//              from it, otherwise inaccurate where it is in front of it, and
//              not observed behind it. One scan in which it is accurate
//              suffices; otherwise one in which it is inaccurate
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/protocols/protocol_result.h"
#include "core/mesh/indexed_mesh.h"
#include "core/scene/camera.h"

namespace octacut {

// A laser scan: points in the frame of the scanner, which is at its origin, in
// metres.
struct LaserScan {
  std::vector<Eigen::Vector3d> points;
  Rigid3d world_from_scan;
};

// Points of all scans in the world.
std::vector<Eigen::Vector3d> MergeScans(const std::vector<LaserScan>& scans);

// `tolerances` in metres, at least one. A mesh is sampled at half the smallest
// of the tolerances and the cell: the program would take its vertices alone.
// One score for each tolerance, in ascending order; figures "points" and "scan
// points".
ProtocolResult MeasureEth3d(const IndexedMesh& mesh,
                            const std::vector<LaserScan>& scans,
                            std::vector<double> tolerances,
                            const Context& context);

}  // namespace octacut
