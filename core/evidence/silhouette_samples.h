// What a labelling leaves uncovered of the silhouettes, view by view, in
// samples as wide as a voxel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

// A view in samples that are one voxel wide at the centre of the root cube, but
// no smaller than a pixel.
struct SampleMap {
  int width = 0;
  int height = 0;
  float scale = 1;                  // samples per pixel
  std::vector<uint8_t> is_sure;     // shows the object beyond doubt; row by row
  std::vector<uint8_t> is_covered;  // has matter on its ray

  size_t Size() const { return is_sure.size(); }
  bool IsUncovered(size_t sample) const {
    return is_sure[sample] && !is_covered[sample];
  }
  // The sample of a point (unit coordinates); -1 when it is out of the frame
  // or behind.
  int At(const ViewProjection& projection, const Eigen::Vector3f& point) const;
};

// The samples of all views. `labels` has one element per voxel, as
// SolveOctahedralCut gives them; matter is where half of the faces are inside:
// the surface is there. Samples are sure where the border of the object is
// farther than a sample and than the view's SureDepth.
std::vector<SampleMap> MapSamples(const ViewSet& views,
                                  const VoxelGrid& voxels,
                                  const std::vector<FaceLabels>& labels,
                                  const Context& context);

struct SampleCounts {
  size_t num_sure = 0;
  size_t num_uncovered = 0;  // of those
};

SampleCounts CountSamples(const std::vector<SampleMap>& maps);

}  // namespace octacut
