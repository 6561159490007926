// Against COLMAP's own image_undistorter, where colmap is installed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "colmap_io/images/undistort.h"
#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/camera_projector.h"
#include "colmap_io/model/read_sparse_model.h"
#include "colmap_io/model/write_sparse_model.h"
#include "tests/colmap_io/images/test_workspace.h"
#include "tests/colmap_io/model/test_cameras.h"

namespace octacut {
namespace {

using testing::FolderTest;
using testing::RingModel;
using testing::Texture;
using testing::WritePicture;

// What COLMAP 3.8 knows; later models are tested against their definitions.
constexpr int kLastModelOfColmap38 = camera_model::kThinPrismFisheye;

class ColmapUndistorterTest : public FolderTest {
 protected:
  void SetUp() override {
    if (std::system("command -v colmap > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "colmap is not installed";
    }
  }

  void RunUndistorter() const {
    const std::string command = fmt::format(
        "QT_QPA_PLATFORM=offscreen colmap image_undistorter --image_path {0}/"
        "images --input_path {0}/sparse/0 --output_path {0}/dense > {0}/log "
        "2>&1",
        folder_.string());
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }
};

// One image a camera of every model.
SparseModel OneImageACamera() {
  SparseModel model = RingModel(TestCameras()[0], 100);
  model.cameras.clear();
  for (const SparseCamera& camera : TestCameras()) {
    if (camera.model_id <= kLastModelOfColmap38) {
      model.cameras.push_back(camera);
    }
  }
  model.images.resize(model.cameras.size());
  for (size_t i = 0; i < model.images.size(); ++i) {
    model.images[i].camera_id = model.cameras[i].id;
  }
  return model;
}

TEST_F(ColmapUndistorterTest, MakesTheSameCamerasAndPixels) {
  const SparseModel model = OneImageACamera();
  const cv::Mat texture = Texture(640, 480);
  WriteSparseModelBinary(model, folder_ / "sparse" / "0");
  for (const SparseImage& image : model.images) {
    WritePicture(folder_ / "images" / image.name, texture);
  }
  RunUndistorter();
  const SparseModel dense = ReadSparseModel(folder_ / "dense" / "sparse");
  for (const SparseImage& image : dense.images) {
    const SparseCamera& original = *model.FindCamera(image.camera_id);
    SCOPED_TRACE(
        fmt::format("camera {}, model {}", original.id, original.model_id));
    const SparseCamera& theirs = *dense.FindCamera(image.camera_id);
    ASSERT_TRUE(IsPinhole(theirs));
    const PinholeCamera ours = UndistortedCamera(original);
    EXPECT_EQ(theirs.width, uint64_t(ours.width));
    EXPECT_EQ(theirs.height, uint64_t(ours.height));
    const CameraIntrinsics intrinsics = CameraProjector(theirs).Intrinsics();
    EXPECT_NEAR(intrinsics.fx, ours.fx, 1e-9);
    EXPECT_NEAR(intrinsics.fy, ours.fy, 1e-9);
    EXPECT_NEAR(intrinsics.cx, ours.cx, 1e-9);
    EXPECT_NEAR(intrinsics.cy, ours.cy, 1e-9);
    const cv::Mat expected =
        cv::imread((folder_ / "dense" / "images" / image.name).string());
    const cv::Mat result = Undistort(texture, original, ours, 0, Context(2));
    ASSERT_EQ(expected.size(), result.size());
    // COLMAP resamples twice when sizes differ, so its borders are off.
    const cv::Rect interior(4, 4, result.cols - 8, result.rows - 8);
    cv::Mat difference;
    cv::absdiff(expected(interior), result(interior), difference);
    const cv::Scalar mean = cv::mean(difference);
    EXPECT_LT(std::max({mean[0], mean[1], mean[2]}), 0.6);
    EXPECT_LE(cv::norm(difference, cv::NORM_INF), 6);
  }
}

}  // namespace
}  // namespace octacut
