#include "core/pipeline/finish_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "core/mesh/audit.h"
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
                         bar(p, 0.6) - 4 * kVoxel,
                         bar(p, 0.4) - 1.1 * kVoxel});
      });
  return {crust.crust, crust.labels};
}

// Seen from a distance of two cubes, with pixels of so many voxels. The thin
// bar is at 0.2 of the frame's height. Above `border` the mask is background.
ViewSet ViewsWithPixels(double voxels, double border = 0.18) {
  const double focal_length = 2 / (voxels * kVoxel);
  PreparedView view;
  view.projection.focal_length = float(focal_length);
  view.projection.linear =
      Eigen::Vector3d(focal_length, focal_length, 1).cast<float>().asDiagonal();
  view.projection.offset = Eigen::Vector3f(0, 0, 1.5f);
  view.projection.width = view.projection.height = int(focal_length);
  cv::Mat mask(view.projection.height, view.projection.width, CV_8UC1, 255.0);
  mask.rowRange(0, int(border * focal_length)).setTo(0);
  view.silhouette = Silhouette(mask);
  return {view};
}

int64_t GenusIn(const ViewSet& views) {
  const FinishedMesh finished = FinalMesh(
      views, BallsWithBars(), UnitCube(), FinishOptions(), Context(2));
  return AuditMesh(finished.mesh, Context(1)).genus;
}

TEST(FinalMesh, RemovesHandlesThatPixelsDoNotShow) {
  EXPECT_EQ(GenusIn(ViewsWithPixels(0.5)), 1);
  EXPECT_EQ(GenusIn(ViewsWithPixels(1)), 1);
  EXPECT_EQ(GenusIn(ViewsWithPixels(2.4)), 0);
}

TEST(FinalMesh, RemovesHandlesThatNoSilhouetteShows) {
  EXPECT_EQ(GenusIn(ViewsWithPixels(0.5, 0)), 0);
  EXPECT_EQ(GenusIn(ViewsWithPixels(1, 0)), 0);
  // Ten of 128 pixels farther away, unless that is by how much the mask is too
  // large.
  ViewSet views = ViewsWithPixels(1, 0.1);
  EXPECT_EQ(GenusIn(views), 0);
  views[0].border_shift = 10;
  EXPECT_EQ(GenusIn(views), 1);
}

TEST(FinalMesh, RemovesHandlesJustInsideBordersThatAreKnown) {
  ViewSet views = ViewsWithPixels(1);
  views[0].border_shift_slack = 0.1f;
  EXPECT_EQ(GenusIn(views), 0);
  views = ViewsWithPixels(1, 0.19);
  views[0].border_shift_slack = 0.1f;
  EXPECT_EQ(GenusIn(views), 1);
}

TEST(FinalMesh, RemovesHandlesThatMasksWhichAreTooLargeMayHaveClosed) {
  ViewSet views = ViewsWithPixels(1);
  views[0].border_shift = 2;
  views[0].border_shift_slack = 0.1f;
  EXPECT_EQ(GenusIn(views), 0);
  // Nothing but the thin bar goes.
  views[0].border_shift = 0.5;
  views[0].silhouette = ViewsWithPixels(1, 0.19)[0].silhouette;
  EXPECT_EQ(GenusIn(views), 1);
}

}  // namespace
}  // namespace octacut
