#include "core/evidence/dense_depths.h"

#include <algorithm>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/evidence/confirmed_depths.h"
#include "core/evidence/contradicted_depths.h"
#include "core/evidence/depth_sweep.h"
#include "core/hull/visual_hull.h"
#include "core/views/view_set.h"

namespace octacut {
namespace {

constexpr double kMaskTolerance = 2;  // as in MaskOptions
constexpr int kMinAgreeingViews = 2;  // as in InsideEvidenceOptions

// Linear between four samples that show the same surface; 0 elsewhere.
float InterpolatedDepth(const SweptDepthMap& map,
                        float u,
                        float v,
                        float tolerance) {
  const float x = u * map.scale - 0.5f;
  const float y = v * map.scale - 0.5f;
  if (!(x >= 0 && y >= 0 && x < float(map.width - 1) &&
        y < float(map.height - 1))) {
    return 0;
  }
  const int column = int(x);
  const int row = int(y);
  const float* upper =
      map.depths.data() + size_t(row) * size_t(map.width) + column;
  const float* lower = upper + map.width;
  const auto [least, most] =
      std::minmax({upper[0], upper[1], lower[0], lower[1]});
  if (!(least > 0) || most - least > tolerance) {
    return 0;
  }
  const float s = x - float(column);
  const float t = y - float(row);
  return (1 - t) * ((1 - s) * upper[0] + s * upper[1]) +
         t * ((1 - s) * lower[0] + s * lower[1]);
}

cv::Mat DepthsOfView(const View& view,
                     const SweptDepthMap& map,
                     float tolerance,
                     double unit) {
  cv::Mat depths = cv::Mat::zeros(view.mask.size(), CV_32FC1);
  for (int y = 0; y < depths.rows; ++y) {
    for (int x = 0; x < depths.cols; ++x) {
      if (view.mask.at<uint8_t>(y, x) >= kObjectThreshold) {
        depths.at<float>(y, x) =
            float(unit * InterpolatedDepth(
                             map, float(x) + 0.5f, float(y) + 0.5f, tolerance));
      }
    }
  }
  return depths;
}

}  // namespace

void DenseDepthsOptions::Check() const {
  CheckOption(
      level >= 4 && level <= 10, "sweep_level", level, "must be in 4 .. 10");
}

std::vector<cv::Mat> SweepDenseDepths(const Scene& scene,
                                      const BoundingCube& cube,
                                      const Eigen::AlignedBox3d& box,
                                      const DenseDepthsOptions& options,
                                      const Context& context) {
  options.Check();
  const ViewSet views = PrepareViews(scene, cube, context, kMaskTolerance);
  const VoxelGrid hull =
      ComputeVisualHull(views, cube.ToUnit(box), {options.level}, context)
          .voxels;
  const float voxel = 1.0f / float(hull.Resolution());
  std::vector<std::vector<int>> neighbors;
  std::vector<SweptDepthMap> maps =
      SweepDepths(views, hull, DepthSweepOptions(), context, &neighbors);
  const auto counts = CountAgreeing(views, maps, neighbors, voxel, context);
  maps = KeepAgreeing(std::move(maps), counts, kMinAgreeingViews);
  const std::vector<JudgedMap> judged = JudgeDepths(views, hull, maps, context);
  maps = WithoutOutvoted(std::move(maps), judged);
  // Samples half a voxel apart on a surface that turns away by 70 degrees.
  const float tolerance = kDepthAgreement * voxel;
  std::vector<cv::Mat> depths(maps.size());
  ParallelEach(context, maps.size(), 1, [&](size_t i) {
    depths[i] = DepthsOfView(scene.views[i], maps[i], tolerance, cube.edge);
  });
  return depths;
}

}  // namespace octacut
