#include "core/pipeline/finish_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

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

// Seen from a distance of two cubes, with pixels of so many voxels.
ViewSet ViewsWithPixels(double voxels) {
  PreparedView view;
  view.projection.linear.setIdentity();
  view.projection.offset = Eigen::Vector3f(0, 0, 1.5f);
  view.projection.focal_length = float(2 / (voxels * kVoxel));
  return {view};
}

int64_t GenusWithPixels(double voxels) {
  ReconstructionSummary summary;
  return AuditMesh(FinalMesh(ViewsWithPixels(voxels),
                             BallsWithBars(),
                             UnitCube(),
                             ReconstructionOptions(),
                             Context(2),
                             &summary)
                       .mesh)
      .genus;
}

TEST(FinalMesh, RemovesHandlesThatPixelsDoNotShow) {
  EXPECT_EQ(GenusWithPixels(0.5), 1);
  EXPECT_EQ(GenusWithPixels(1), 1);
  EXPECT_EQ(GenusWithPixels(2.4), 0);
}

}  // namespace
}  // namespace octacut
