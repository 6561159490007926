#include "core/pipeline/finish_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "tests/core/extract/label_crust.h"

namespace octacut {
namespace {

constexpr int kMeshLevel = 6;
constexpr double kVoxel = 1.0 / (1 << kMeshLevel);

// Two balls, joined by a thick bar and one of two voxels.
LabeledVoxels BallsWithBars() {
  const auto bar = [](const Eigen::Vector3d& p, double y) {
    const Eigen::Vector3d nearest(std::clamp(p.x(), 0.28, 0.72), y, 0.5);
    return (p - nearest).norm();
  };
  const LabelledCrust crust =
      LabelShape(kMeshLevel, [&](const Eigen::Vector3d& p) {
        return std::min({(p - Eigen::Vector3d(0.28, 0.5, 0.5)).norm() - 0.17,
                         (p - Eigen::Vector3d(0.72, 0.5, 0.5)).norm() - 0.17,
                         bar(p, 0.6) - 3 * kVoxel,
                         bar(p, 0.4) - 1.1 * kVoxel});
      });
  return {crust.crust, crust.labels};
}

// Seen from a distance of two cubes, with pixels of so many voxels. The border
// of the mask passes beside the thin bar, or there is none.
ViewSet ViewsWithPixels(double voxels, bool shows_bar = true) {
  const double focal_length = 2 / (voxels * kVoxel);
  PreparedView view;
  view.projection.focal_length = float(focal_length);
  view.projection.linear =
      Eigen::Vector3d(focal_length, focal_length, 1).cast<float>().asDiagonal();
  view.projection.offset = Eigen::Vector3f(0, 0, 1.5f);
  view.projection.width = view.projection.height = int(focal_length);
  cv::Mat mask(view.projection.height, view.projection.width, CV_8UC1, 255.0);
  if (shows_bar) {
    mask.rowRange(0, int(0.18 * focal_length)).setTo(0);
  }
  view.silhouette = Silhouette(mask);
  return {view};
}

int64_t GenusIn(const ViewSet& views) {
  ReconstructionSummary summary;
  return AuditMesh(FinalMesh(views,
                             BallsWithBars(),
                             UnitCube(),
                             ReconstructionOptions(),
                             Context(2),
                             &summary)
                       .mesh)
      .genus;
}

TEST(FinalMesh, RemovesHandlesThatPixelsDoNotShow) {
  EXPECT_EQ(GenusIn(ViewsWithPixels(0.5)), 1);
  EXPECT_EQ(GenusIn(ViewsWithPixels(1)), 1);
  EXPECT_EQ(GenusIn(ViewsWithPixels(2.4)), 0);
}

TEST(FinalMesh, RemovesHandlesThatNoSilhouetteShows) {
  EXPECT_EQ(GenusIn(ViewsWithPixels(0.5, false)), 0);
  EXPECT_EQ(GenusIn(ViewsWithPixels(1, false)), 0);
}

}  // namespace
}  // namespace octacut
