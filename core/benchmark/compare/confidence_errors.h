// Whether a mesh knows where it is wrong: errors of the parts that it is least
// and most confident of.
#pragma once

#include <vector>

#include "core/mesh/indexed_mesh.h"
#include "core/mesh/surface_samples.h"

namespace octacut {

// Mean distances to the reference, of tenths of the area that counts.
struct ConfidenceErrors {
  double least_confident = 0;
  double most_confident = 0;

  // 0 where the most confident tenth has no error.
  double Ratio() const {
    return most_confident > 0 ? least_confident / most_confident : 0;
  }
};

// `samples` are those of SampleSurface for `mesh`, which has a confidence;
// `distances` one per sample, not a number where it does not count. Samples of
// the same confidence are in no tenth before others: their mean counts for
// each.
ConfidenceErrors MeasureConfidenceErrors(
    const IndexedMesh& mesh,
    const std::vector<SurfaceSample>& samples,
    const std::vector<double>& distances);

}  // namespace octacut
