// The shared data sets load, and their regions are right. Skipped without
// them.
#include "tests/colmap_io/images/shared_data.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "colmap_io/images/load_scene.h"

namespace octacut {
namespace {

struct Case {
  std::string folder;
  std::string model;
  size_t num_views;
  double max_mean_object;  // share of object in the masks' windows
};

class SharedData : public ::testing::TestWithParam<Case> {};

TEST_P(SharedData, Loads) {
  const std::filesystem::path workspace =
      testing::SharedData() / GetParam().folder;
  if (!std::filesystem::is_directory(workspace)) {
    GTEST_SKIP() << workspace << " is not there";
  }
  LoadSceneOptions options;
  options.workspace.input_path = workspace / GetParam().model;
  const LoadedScene loaded = LoadScene(workspace, options, 9, Context(-1));
  EXPECT_EQ(loaded.summary.num_views, GetParam().num_views);
  EXPECT_EQ(loaded.region.source, RegionSource::kSilhouettes);
  std::cout << loaded.region.box.min().transpose() << " | "
            << loaded.region.box.max().transpose() << " points "
            << loaded.summary.num_points << "/"
            << loaded.summary.num_model_points << " MB "
            << loaded.summary.scene_bytes / 1e6 << " s "
            << loaded.summary.mask_seconds << " "
            << loaded.summary.region_seconds << " "
            << loaded.summary.image_seconds << "\n";
  for (const View& view : loaded.scene.views) {
    EXPECT_EQ(view.image.type(), CV_8UC3);
    EXPECT_EQ(view.mask.type(), CV_8UC1);
    EXPECT_EQ(view.image.cols, view.camera.width);
    EXPECT_EQ(view.image.rows, view.camera.height);
    EXPECT_EQ(view.mask.size(), view.image.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Data,
                         SharedData,
                         ::testing::Values(Case{"temple", "sparse/0", 47, 1},
                                           Case{"temple", "calibration", 47, 1},
                                           Case{"dino", "sparse/0", 16, 1},
                                           Case{"bunny", "sparse/0", 36, 1},
                                           Case{"igea", "sparse/0", 48, 1},
                                           Case{"igea", "sparse_gt", 48, 1},
                                           Case{"rocker", "sparse/0", 36, 1},
                                           Case{"rocker", "sparse_gt", 36, 1}));

}  // namespace
}  // namespace octacut
