#include "core/evidence/silhouette_samples.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <utility>

namespace octacut {
namespace {

constexpr int kSamplesLevel = 4;
constexpr int kPixelsPerVoxel = 4;

// A bar across the frame, which shows the root cube from a distance of two
// cubes. Half its width is in voxels.
ViewSet ViewOfBar(double half_width) {
  constexpr int kSize = kPixelsPerVoxel << kSamplesLevel;
  PreparedView view;
  view.projection.linear =
      Eigen::Vector3f(2 * kSize, 2 * kSize, 1).asDiagonal();
  view.projection.offset = Eigen::Vector3f(0, 0, 1.5f);
  view.projection.focal_length = 2 * kSize;
  view.projection.width = view.projection.height = kSize;
  cv::Mat mask(kSize, kSize, CV_8UC1, cv::Scalar(0));
  cv::line(mask,
           {0, 0},
           {kSize - 1, kSize - 1},
           255,
           int(2 * half_width * kPixelsPerVoxel));
  view.silhouette = Silhouette(mask);
  return {view};
}

SampleCounts CountWithoutMatter(const ViewSet& views) {
  return CountSamples(MapSamples(
      views, VoxelGrid::FromCodes(kSamplesLevel, {}), {}, Context(1)));
}

TEST(MapSamples, AreSureAVoxelFromTheBorderAndNoNearer) {
  for (const auto& [half_width, is_sure] :
       {std::pair(0.75, false), std::pair(1.5, true)}) {
    const SampleCounts counts = CountWithoutMatter(ViewOfBar(half_width));
    EXPECT_EQ(counts.num_sure > 0, is_sure) << half_width;
    EXPECT_EQ(counts.num_uncovered, counts.num_sure);
  }
}

TEST(MapSamples, AreNotSureWhereTheBorderMayLie) {
  ViewSet views = ViewOfBar(2);
  const size_t exact = CountWithoutMatter(views).num_sure;
  views[0].mask_tolerance = 5;
  const size_t tolerant = CountWithoutMatter(views).num_sure;
  EXPECT_LT(tolerant, exact);
  EXPECT_GT(tolerant, 0u);
  views[0].mask_tolerance = 10;
  EXPECT_EQ(CountWithoutMatter(views).num_sure, 0u);
}

}  // namespace
}  // namespace octacut
