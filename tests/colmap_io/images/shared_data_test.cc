// The shared data sets load, and their regions are right. Skipped without
// them.
#include "tests/colmap_io/images/shared_data.h"

#include <gtest/gtest.h>

#include <string>

#include "colmap_io/images/load_scene.h"

namespace octacut {
namespace {

struct Case {
  std::string folder;
  std::string model;
  size_t num_views;
  bool load_images;
  // What is known of the object's bounding box; empty: nothing.
  Eigen::AlignedBox3d box;
  // How much longer a side of the region may be: silhouettes do not see
  // concavities and undersides.
  double most_longer;
};

void PrintTo(const Case& c, std::ostream* os) {
  *os << c.folder << " " << c.model;
}

class SharedData : public ::testing::TestWithParam<Case> {};

TEST_P(SharedData, LoadsWithTheRightRegion) {
  const Case& c = GetParam();
  const std::filesystem::path workspace = testing::SharedData() / c.folder;
  if (!std::filesystem::is_directory(workspace)) {
    GTEST_SKIP() << workspace << " is not there";
  }
  LoadSceneOptions options;
  options.workspace.input_path = workspace / c.model;
  options.load_images = c.load_images;
  const LoadedScene loaded = LoadScene(workspace, options, 9, Context(-1));
  EXPECT_EQ(loaded.summary.num_views, c.num_views);
  EXPECT_EQ(loaded.region.source, RegionSource::kSilhouettes);
  size_t bytes = 0;
  for (const View& view : loaded.scene.views) {
    EXPECT_EQ(view.mask.cols, view.camera.width);
    EXPECT_EQ(view.mask.rows, view.camera.height);
    if (c.load_images) {
      EXPECT_EQ(view.mask.size(), view.image.size());
    }
    bytes += 4 * view.mask.total();
  }
  EXPECT_EQ(loaded.summary.scene_bytes, bytes);
  for (const Eigen::Vector3d& point : loaded.scene.points) {
    EXPECT_TRUE(loaded.region.box.contains(point));
  }
  if (!c.box.isEmpty()) {
    const Eigen::Vector3d slack = 0.002 * c.box.sizes();
    EXPECT_TRUE(loaded.region.box.contains(
        Eigen::AlignedBox3d(c.box.min() + slack, c.box.max() - slack)));
    EXPECT_TRUE((loaded.region.box.sizes().array() <=
                 (1 + c.most_longer) * c.box.sizes().array())
                    .all());
  }
}

Eigen::AlignedBox3d Box(
    double x0, double y0, double z0, double x1, double y1, double z1) {
  return {Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1)};
}

const Eigen::AlignedBox3d kNotKnown;
const Eigen::AlignedBox3d kTemple =
    Box(-0.0231, -0.0380, -0.0919, 0.0786, 0.1216, -0.0174);
const Eigen::AlignedBox3d kDino =
    Box(-0.0619, -0.0189, -0.0578, 0.0109, 0.0682, 0.0155);
const Eigen::AlignedBox3d kIgea =
    Box(-0.2209, -0.3167, -0.3176, 0.2209, 0.3167, 0.3176);
const Eigen::AlignedBox3d kRocker =
    Box(-0.1301, -0.2206, -0.4289, 0.1300, 0.2206, 0.4290);

INSTANTIATE_TEST_SUITE_P(
    Data,
    SharedData,
    ::testing::Values(Case{"temple", "sparse/0", 47, true, kNotKnown, 0},
                      Case{"temple", "calibration", 47, false, kTemple, 0.10},
                      Case{"dino", "sparse/0", 16, true, kDino, 0.12},
                      Case{"bunny", "sparse/0", 36, false, kNotKnown, 0},
                      Case{"igea", "sparse/0", 48, false, kIgea, 0.06},
                      Case{"igea", "sparse_gt", 48, false, kIgea, 0.06},
                      Case{"rocker", "sparse/0", 36, true, kRocker, 0.10},
                      Case{"rocker", "sparse_gt", 36, false, kRocker, 0.10}));

}  // namespace
}  // namespace octacut
