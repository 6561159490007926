// Coarse depth maps by plane sweeping, restricted to a voxel hull.
//
// Each view is compared with a few neighbouring views along its own viewing
// rays by zero-mean normalised cross-correlation; no surface is needed
// beforehand, so it can tell what lies in concavities of the hull (Hernandez,
// Vogiatzis, Cipolla CVPR 2007; Campbell et al. ECCV 2008).
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

// Larger sweeps do not pay (six neighbours, windows of 7 x 7, a least score of
// 0.4): docs/experiments/interior.md.
struct DepthSweepOptions {
  int num_neighbors = 4;  // views compared with each view; 2 .. 8
  double min_angle = 4;   // degrees between the viewing directions
  double max_angle = 45;  // of neighbours
  // Pixels and depth planes across a hull voxel.
  static constexpr double kSamplesPerVoxel = 2;
  static constexpr double kPlanesPerVoxel = 1;
  // Of the correlation window, in samples.
  static constexpr int kWindowRadius = 2;
  // Correlation of an accepted depth.
  static constexpr double kMinScore = 0.5;
  // Grey levels: its square is added to the variance of every window, so that
  // windows of less contrast do not correlate.
  double plain_deviation = 2;
  void Check() const;
};

// A view's depth map at the hull's scale; one sample is 1 / scale pixels.
struct SweptDepthMap {
  int width = 0;
  int height = 0;
  float scale = 1;
  std::vector<float> depths;  // unit coordinates; 0 where nothing was found
  // Of SweepDepths, as ShareWithDetail has it: how much there was to match.
  std::vector<float> detail;

  // Homogeneous pixel coordinates of a sample's centre.
  Eigen::Vector3f Pixel(int x, int y) const {
    return {(float(x) + 0.5f) / scale, (float(y) + 0.5f) / scale, 1};
  }
  // The sample at pixel coordinates of the view; none out of the map.
  std::optional<size_t> SampleAt(float u, float v) const {
    // Points just before the camera are at pixels that no int holds.
    const float x = u * scale;
    const float y = v * scale;
    if (x >= 0 && y >= 0 && x < float(width) && y < float(height)) {
      return size_t(y) * size_t(width) + size_t(x);
    }
    return std::nullopt;
  }
  // Depth at pixel coordinates of the view; 0 for none.
  float DepthAt(float u, float v) const { return ValueAt(depths, u, v); }
  // The same of other values, one per sample.
  float ValueAt(const std::vector<float>& values, float u, float v) const {
    const std::optional<size_t> sample = SampleAt(u, v);
    return sample ? values[*sample] : 0;
  }
};

// Calls visit(x, y, depth, ray) for every depth of a view's map; what it found
// is projection.center + depth * ray.
template <typename Visit>
void ForEachDepth(const SweptDepthMap& map,
                  const ViewProjection& projection,
                  Visit&& visit) {
  const Eigen::Matrix3f rays = projection.RaysOfPixels();
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const float depth = map.depths[size_t(y) * map.width + x];
      if (depth > 0) {
        visit(x, y, depth, Eigen::Vector3f(rays * map.Pixel(x, y)));
      }
    }
  }
}

// One map per view. The neighbours that were compared with view i come back in
// neighbors[i].
std::vector<SweptDepthMap> SweepDepths(
    const ViewSet& views,
    const VoxelGrid& hull,
    const DepthSweepOptions& options,
    const Context& context,
    std::vector<std::vector<int>>* neighbors);

// Bytes that SweepDepths will need for a hull of (2^hull_level)^3 voxels,
// roughly.
size_t EstimateSweepBytes(size_t num_views,
                          int hull_level,
                          const Context& context);

}  // namespace octacut
