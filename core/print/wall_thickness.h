// How thick the walls of a closed mesh are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct WallThicknessOptions {
  int64_t num_samples = 200000;
  // Walls below this count as thin.
  double min_wall = 0;
};

struct ThinPlace {
  Eigen::Vector3d point;  // on the surface
  double thickness;
};

struct WallThickness {
  // Fraction of the surface that has an opposite wall: a ray from the surface
  // inwards, along the normal, hits a surface that faces it within 45 degrees.
  // The rest, such as near sharp edges, has no thickness.
  double measured_share = 0;
  // Statistics over the measured surface, by area; 0 if nothing was measured.
  double min = 0;
  double percentile_1 = 0;
  double percentile_5 = 0;
  double median = 0;
  double max = 0;
  double thin_share = 0;  // of the measured surface
  // Fractions of the measured surface in 20 bins of equal width from 0 to
  // `max`.
  std::vector<double> histogram;
  // At most ten, thinnest first; each farther from the thinner ones than a
  // twentieth of the diagonal of the bounding box.
  std::vector<ThinPlace> thinnest;
};

// Area-weighted, in the units of the mesh. The same for any number of threads.
// Throws InputError for a mesh without area.
WallThickness MeasureWallThickness(const IndexedMesh& mesh,
                                   const WallThicknessOptions& options,
                                   const Context& context);

}  // namespace octacut
