// Where an umbrella's vertex belongs. For core/extract alone.
#pragma once

#include <Eigen/Core>

#include "core/extract/corner_umbrellas.h"

namespace octacut {

// Mean of the centres of the voxels in the given octants, from the point the
// octants meet in, in voxels.
inline Eigen::Vector3d OctantMean(OctantMask octants) {
  Eigen::Vector3i sum = Eigen::Vector3i::Zero();
  int count = 0;
  for (int octant = 0; octant < 8; ++octant) {
    if (octants >> octant & 1) {
      sum += Eigen::Vector3i(octant & 1, octant >> 1 & 1, octant >> 2 & 1) * 2 -
             Eigen::Vector3i::Ones();
      ++count;
    }
  }
  return count == 0 ? Eigen::Vector3d::Zero()
                    : Eigen::Vector3d(sum.cast<double>() / (2.0 * count));
}

}  // namespace octacut
