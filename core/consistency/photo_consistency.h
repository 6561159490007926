// Photo-consistency of crust voxels [HK06 section 3, eq. (1)].
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"
#include "core/visibility/surface_shape.h"
#include "core/visibility/visibility.h"

namespace octacut {

enum class ConsistencyMeasure {
  kNormalizedVariance,  // equation (1): colours normalised per image
  kNcc,                 // zero-mean normalised cross-correlation of pairs
  kVariance,            // plain weighted colour variance
};

struct ConsistencyOptions {
  ConsistencyMeasure measure = ConsistencyMeasure::kNormalizedVariance;
  // Samples are (2 r + 1)^2 points on the surface through the voxel's centre, a
  // voxel apart or, where that is more, a pixel; r in 1 .. 4. 3 is worse where
  // voxels have two pixels: docs/experiments/photo_consistency.md.
  int patch_radius = 2;
  // Where voxels are as small as pixels, r grows (to 3, with this default)
  // until the patch spans this many pixels of the average view: fewer hold too
  // little texture. Igea at 512^3 has 0.074 instead of 0.089 %:
  // docs/experiments/photo_consistency.md.
  double min_patch_pixels = 5;
  // Value of voxels that fewer than two views see, and of plain patches, so
  // that the surface closes there by minimal area; 0 .. 1. Half-way, because
  // they say neither: docs/experiments/photo_consistency.md.
  double neutral = 0.5;
  // Standard deviation of pixel noise, in grey levels of 255: contrast below
  // it counts as plain. Not varied alone.
  double pixel_noise = 3;
  // Weight of differences in chroma relative to differences in brightness,
  // which highlights change most; 0 .. 8.
  double chroma_weight = 2;
  void Check() const;
};

struct ConsistencySummary {
  size_t num_voxels = 0;
  size_t num_unseen = 0;  // by fewer than two views
  double mean = 0;        // of phi over the seen voxels

  // That of both sets of voxels together.
  void Add(const ConsistencySummary& other);
};

struct PhotoConsistency {
  std::vector<float> phi;        // one per voxel, 0 (consistent) .. 1
  std::vector<uint8_t> is_seen;  // one per voxel: by at least two views
  ConsistencySummary summary;
};

// phi of every voxel of `voxels`, one shape per voxel (where that has no
// normal, the voxel counts as unseen), sampled from the pyramid level whose
// pixels match the spacing of the samples.
PhotoConsistency EstimateConsistency(const ViewSet& views,
                                     const VoxelGrid& voxels,
                                     const std::vector<SurfaceShape>& shapes,
                                     const Visibility& visibility,
                                     const ConsistencyOptions& options,
                                     const Context& context);

}  // namespace octacut
