#include "core/evidence/sweep_view.h"

#include <algorithm>
#include <limits>

namespace octacut {
namespace {

void MarkHullDepths(const VoxelGrid& hull, SweepView* view) {
  const float voxel = 1.0f / float(hull.Resolution());
  hull.ForEach([&](VoxelGrid::Index, MortonCode code) {
    const std::optional<ProjectedPoint> p = view->projection->Project(
        VoxelCenter(DecodeMorton(code), hull.Level()));
    if (!p || p->depth <= voxel) {
      return;
    }
    const float reach =
        0.5f * view->scale * view->projection->Footprint(voxel, p->depth);
    const float x = p->u * view->scale;
    const float y = p->v * view->scale;
    const int x0 = std::max(0, int(x - reach));
    const int y0 = std::max(0, int(y - reach));
    const int x1 = std::min(view->grey.cols - 1, int(x + reach));
    const int y1 = std::min(view->grey.rows - 1, int(y + reach));
    for (int row = y0; row <= y1; ++row) {
      for (int column = x0; column <= x1; ++column) {
        float& near = view->near_depth(row, column);
        float& far = view->far_depth(row, column);
        near = std::min(near, p->depth - voxel);
        far = std::max(far, p->depth + voxel);
      }
    }
  });
}

}  // namespace

SweepView ReduceForSweep(const PreparedView& view,
                         const VoxelGrid& hull,
                         double samples_per_voxel) {
  const ViewProjection& projection = view.projection;
  const float voxel = 1.0f / float(hull.Resolution());
  SweepView reduced;
  reduced.projection = &projection;
  reduced.scale = std::min(
      1.0f, float(samples_per_voxel) / projection.CenterFootprint(voxel));
  const int width = std::max(2, int(projection.width * reduced.scale));
  const int height = std::max(2, int(projection.height * reduced.scale));
  reduced.grey.create(height, width);
  const PyramidLevel& level = view.pyramid.LevelForFootprint(1 / reduced.scale);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Float4 color = level.Sample((float(x) + 0.5f) / reduced.scale,
                                        (float(y) + 0.5f) / reduced.scale);
      reduced.grey(y, x) =
          0.114f * color[0] + 0.587f * color[1] + 0.299f * color[2];
    }
  }
  reduced.near_depth.create(height, width);
  reduced.far_depth.create(height, width);
  reduced.near_depth.setTo(std::numeric_limits<float>::infinity());
  reduced.far_depth.setTo(0);
  MarkHullDepths(hull, &reduced);
  return reduced;
}

}  // namespace octacut
