// Analytic shapes with noisy photo-consistency, cut in the octahedral graph and
// in voxel-centre graphs.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/cut_instances.h"
#include "tests/bench/graph_norms.h"

namespace octacut {

// Signed distance in voxels, > 0 outside, to first order.
using SignedDistance = double (*)(const Eigen::Vector3d& p, double resolution);

struct NoisyShape {
  std::string name;
  SignedDistance distance;
};
const std::vector<NoisyShape>& NoisyShapes();

// A crust of four voxels to either side; the noise of phi has that spread.
CutInstance MakeNoisyInstance(const NoisyShape& shape,
                              int resolution,
                              double noise,
                              uint64_t seed);

struct CutMeasure {
  size_t num_nodes = 0;
  size_t num_edges = 0;
  double seconds = 0;   // of CPU
  double bytes = 0;     // of the graph as the solver holds it
  double greatest = 0;  // distance of a surface point, in voxels
  double mean = 0;
  double roughness = 0;  // RMS of the distance less that of its vicinity
};

// The octahedral graph by octacut; points where cut edges have their middle.
CutMeasure CutOctahedral(const CutInstance& instance, const NoisyShape& shape);

// A voxel-centre graph by OpenCV's solver; an edge weighs what its direction
// does times the mean weight of its two voxels.
CutMeasure CutVoxelCentres(const CutInstance& instance,
                           const NoisyShape& shape,
                           int num_neighbors);

}  // namespace octacut
