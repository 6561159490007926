#include "core/evidence/depth_sweep.h"

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/evidence/neighbor_views.h"
#include "core/evidence/pick_depths.h"
#include "core/evidence/score_volume.h"
#include "core/evidence/sweep_view.h"
#include "core/evidence/window_detail.h"

namespace octacut {

void DepthSweepOptions::Check() const {
  CheckOption(num_neighbors >= 2 && num_neighbors <= 8,
              "depth_sweep.num_neighbors",
              num_neighbors,
              "must be in 2 .. 8");
  CheckOption(min_angle >= 0 && min_angle < max_angle,
              "depth_sweep.min_angle",
              min_angle,
              "must be at least 0 and less than max_angle");
  CheckOption(max_angle <= 90,
              "depth_sweep.max_angle",
              max_angle,
              "must be at most 90");
  CheckOption(plain_deviation > 0 && plain_deviation <= 64,
              "depth_sweep.plain_deviation",
              plain_deviation,
              "must be positive and at most 64");
}

std::vector<SweptDepthMap> SweepDepths(
    const ViewSet& views,
    const VoxelGrid& hull,
    const DepthSweepOptions& options,
    const Context& context,
    std::vector<std::vector<int>>* neighbors) {
  options.Check();
  Phase phase(context, "depth sweep", 2 * views.size());
  *neighbors = SelectNeighborViews(
      views, options.num_neighbors, options.min_angle, options.max_angle);
  std::vector<SweepView> reduced(views.size());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    reduced[i] =
        ReduceForSweep(views[i], hull, DepthSweepOptions::kSamplesPerVoxel);
    phase.Advance();
  });
  std::vector<SweptDepthMap> maps(views.size());
  const float spacing = 1.0f / float(hull.Resolution()) /
                        float(DepthSweepOptions::kPlanesPerVoxel);
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    // One neighbour alone cannot tell an occlusion from a mismatch.
    const ScoreVolume volume =
        (*neighbors)[i].size() >= 2
            ? ScorePlanes(reduced, int(i), (*neighbors)[i], spacing, options)
            : ScoreVolume();
    maps[i] =
        PickDepths(reduced[i], volume, float(DepthSweepOptions::kMinScore));
    const cv::Mat1f detail = ShareWithDetail(reduced[i].grey,
                                             DepthSweepOptions::kWindowRadius,
                                             float(options.plain_deviation));
    maps[i].detail.assign(detail.begin(), detail.end());
    phase.Advance();
  });
  return maps;
}

size_t EstimateSweepBytes(size_t num_views,
                          int hull_level,
                          const Context& context) {
  const double resolution = double(1u << hull_level);
  const double side = resolution * DepthSweepOptions::kSamplesPerVoxel;
  const double num_planes = resolution * DepthSweepOptions::kPlanesPerVoxel;
  // A reduced view and its depths, and those of a second sweep with their
  // confidence: 41 bytes per sample. The scores of all planes for each thread.
  return size_t(side * side *
                (41 * double(num_views) +
                 num_planes * sizeof(float) * context.NumThreads()));
}

}  // namespace octacut
