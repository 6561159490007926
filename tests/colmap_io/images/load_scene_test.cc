#include "colmap_io/images/load_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_io/images/filled_bites.h"
#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/camera_projector.h"
#include "colmap_io/model/write_sparse_model.h"
#include "tests/colmap_io/images/test_workspace.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

using testing::Recorder;
using testing::RingModel;
using testing::RingPose;
using testing::SphereMask;
using testing::Texture;
using testing::WritePicture;
using testing::WriteText;

constexpr int kNumImages = 12;
const SparseCamera kRadial = {
    1, camera_model::kSimpleRadial, 320, 240, {300, 158, 121, -0.12}};

// A project: twelve views of a sphere of radius 0.8 about the origin.
class LoadSceneTest : public testing::FolderTest {
 protected:
  void SetUp() override {
    const SparseCamera& camera = kRadial;
    static const std::vector<cv::Mat> kMasks = [&] {
      std::vector<cv::Mat> result;
      result.reserve(kNumImages);
      for (int i = 0; i < kNumImages; ++i) {
        result.push_back(SphereMask(camera, RingPose(i, kNumImages), 0.8));
      }
      return result;
    }();
    model_ = RingModel(camera, kNumImages);
    WriteSparseModelBinary(model_, folder_ / "sparse" / "0");
    for (int i = 0; i < kNumImages; ++i) {
      WritePicture(folder_ / "images" / model_.images[i].name,
                   Texture(int(camera.width), int(camera.height)));
      WritePicture(MaskPath(i), kMasks[i]);
    }
  }
  fs::path MaskPath(int i) const {
    return folder_ / "masks" / (model_.images[i].name + ".png");
  }
  LoadedScene Load(const LoadSceneOptions& options = {},
                   int level = 9,
                   int num_threads = 2) {
    return LoadScene(folder_, options, level, Context(num_threads, &recorder_));
  }
  std::string ErrorOf(const LoadSceneOptions& options = {}) {
    return InputErrorOf([&] { Load(options); });
  }

  SparseModel model_;
  Recorder recorder_;
};

// Of several objects, a given box holds one.
TEST_F(LoadSceneTest, KeepsThePointsInAGivenBox) {
  for (const double x : {-0.6, -0.2, 0.3}) {
    SparsePoint& point = model_.points.emplace_back();
    point.id = model_.points.size();
    point.xyz = {x, 0, 0};
    point.error = 0.5;
    point.track = {{1, 0}, {2, 0}, {3, 0}};
    for (SparseImage& image : model_.images) {
      if (image.id <= 3) {
        point.track[image.id - 1].point2D_index =
            uint32_t(image.observations.size());
        image.observations.push_back({1, 1, point.id});
      }
    }
  }
  WriteSparseModelBinary(model_, folder_ / "sparse" / "0");
  EXPECT_EQ(Load().scene.points.size(), 3u);
  LoadSceneOptions options;
  options.region.bounding_box = {Eigen::Vector3d(-0.5, -0.9, -0.9),
                                 Eigen::Vector3d(0.9, 0.9, 0.9)};
  const LoadedScene loaded = Load(options);
  ASSERT_EQ(loaded.scene.points.size(), 2u);
  EXPECT_EQ(loaded.scene.points[0].x(), -0.2);
  EXPECT_EQ(loaded.summary.num_points, 2u);
}

// Masks of the scene agree with the sphere, except on its outline.
void ExpectSphere(const LoadedScene& loaded) {
  for (const View& view : loaded.scene.views) {
    const Eigen::Vector3d& middle = view.cam_from_world.translation;
    ASSERT_EQ(view.mask.cols, view.camera.width);
    ASSERT_EQ(view.mask.rows, view.camera.height);
    for (int y = 0; y < view.mask.rows; ++y) {
      for (int x = 0; x < view.mask.cols; ++x) {
        const double miss = view.camera.Unproject({x + 0.5, y + 0.5})
                                .normalized()
                                .cross(middle)
                                .norm();
        const double pixel = 4 / view.camera.fx;
        // What the photograph does not show is black and unknown.
        if (!view.image.empty() &&
            view.image.at<cv::Vec3b>(y, x) == cv::Vec3b(0, 0, 0)) {
          ASSERT_EQ(view.mask.at<uint8_t>(y, x), 255);
          ASSERT_FALSE(view.unknown.empty());
          ASSERT_EQ(view.unknown.at<uint8_t>(y, x), 255);
          continue;
        }
        if (std::abs(miss - 0.8) > 1.5 * pixel) {
          ASSERT_EQ(view.mask.at<uint8_t>(y, x) >= 128, miss < 0.8)
              << view.name << " " << x << " " << y;
        }
      }
    }
  }
}

TEST_F(LoadSceneTest, UndistortsCropsAndFindsTheRegion) {
  const LoadedScene loaded = Load();
  EXPECT_EQ(loaded.summary.num_views, size_t(kNumImages));
  EXPECT_EQ(loaded.region.source, RegionSource::kSilhouettes);
  EXPECT_TRUE(loaded.region.box.contains(
      Eigen::AlignedBox3d(Eigen::Vector3d(-0.79, -0.79, -0.79),
                          Eigen::Vector3d(0.79, 0.79, 0.79))));
  EXPECT_LT(loaded.region.box.sizes().x(), 1.85);
  ExpectSphere(loaded);
  size_t bytes = 0;
  for (const View& view : loaded.scene.views) {
    EXPECT_EQ(view.image.size(), view.mask.size());
    EXPECT_LT(view.camera.width, 220);
    bytes += view.image.total() * 4;
    // Colours are those of the photograph's pixel.
    const Eigen::Vector2d pixel(30.5, 40.5);
    const auto source =
        CameraProjector(kRadial).ImgFromCam(view.camera.Unproject(pixel));
    const cv::Vec3d expected = testing::TextureAt(source->x(), source->y());
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(view.image.at<cv::Vec3b>(40, 30)[c], expected[c], 2.5);
    }
  }
  EXPECT_EQ(loaded.summary.scene_bytes, bytes);
  EXPECT_TRUE(recorder_.warnings.empty());
}

TEST_F(LoadSceneTest, HoldsLittleForACoarseLevel) {
  const LoadedScene fine = Load({}, 9);
  const LoadedScene coarse = Load({}, 5);
  EXPECT_LT(coarse.summary.scene_bytes, fine.summary.scene_bytes / 3);
  ExpectSphere(coarse);
}

void ExpectSameScene(const LoadedScene& one, const LoadedScene& other) {
  ASSERT_EQ(one.scene.views.size(), other.scene.views.size());
  EXPECT_EQ(one.region.cube.edge, other.region.cube.edge);
  for (size_t i = 0; i < one.scene.views.size(); ++i) {
    const View& a = one.scene.views[i];
    const View& b = other.scene.views[i];
    EXPECT_EQ(a.camera.cx, b.camera.cx);
    EXPECT_EQ(cv::norm(a.image, b.image, cv::NORM_INF), 0);
    EXPECT_EQ(cv::norm(a.mask, b.mask, cv::NORM_INF), 0);
  }
}

TEST_F(LoadSceneTest, IsTheSameForAnyNumberOfThreads) {
  ExpectSameScene(Load({}, 8, 1), Load({}, 8, 4));
}

TEST_F(LoadSceneTest, SmallDecodeBudgetChangesNothing) {
  LoadSceneOptions options;
  options.decode_budget = 1;
  ExpectSameScene(Load(options), Load());
}

TEST_F(LoadSceneTest, TakesMasksOfUndistortedImages) {
  const PinholeCamera camera = UndistortedCamera(kRadial);
  const SparseCamera pinhole = {1,
                                camera_model::kPinhole,
                                uint64_t(camera.width),
                                uint64_t(camera.height),
                                {camera.fx, camera.fy, camera.cx, camera.cy}};
  ASSERT_NE(camera.width, 320);
  for (int i = 0; i < kNumImages; ++i) {
    WritePicture(MaskPath(i),
                 SphereMask(pinhole, RingPose(i, kNumImages), 0.8));
  }
  ExpectSphere(Load());
}

TEST_F(LoadSceneTest, TakesMasksOfPhotographsInADenseFolder) {
  const PinholeCamera camera = UndistortedCamera(kRadial);
  const SparseCamera pinhole = {1,
                                camera_model::kPinhole,
                                uint64_t(camera.width),
                                uint64_t(camera.height),
                                {camera.fx, camera.fy, camera.cx, camera.cy}};
  const fs::path dense = folder_ / "dense";
  WriteSparseModelBinary(RingModel(pinhole, kNumImages), dense / "sparse");
  for (int i = 0; i < kNumImages; ++i) {
    WritePicture(dense / "images" / model_.images[i].name,
                 Texture(camera.width, camera.height));
  }
  // The masks are those of the project beside it, in its geometry.
  const LoadedScene loaded = LoadScene(dense, {}, 9, Context(2, &recorder_));
  EXPECT_EQ(loaded.summary.num_views, size_t(kNumImages));
  ExpectSphere(loaded);
  fs::remove_all(folder_ / "sparse");
  EXPECT_THAT(InputErrorOf([&] { LoadScene(dense, {}, 9, Context(2)); }),
              HasSubstr("--original_path"));
}

TEST_F(LoadSceneTest, NeedsNoImagesForMasksAlone) {
  fs::remove_all(folder_ / "images");
  LoadSceneOptions options;
  EXPECT_THAT(ErrorOf(options),
              HasSubstr("the folder of images does not exist"));
  options.load_images = false;
  const LoadedScene loaded = Load(options);
  ExpectSphere(loaded);
  EXPECT_TRUE(loaded.scene.views[0].image.empty());
}

TEST_F(LoadSceneTest, UsesAGivenBox) {
  LoadSceneOptions options;
  options.region.bounding_box = {Eigen::Vector3d(-0.5, -0.5, -0.5),
                                 Eigen::Vector3d(0.5, 0.5, 0.5)};
  const LoadedScene loaded = Load(options);
  EXPECT_EQ(loaded.region.source, RegionSource::kGiven);
  EXPECT_LT(loaded.summary.scene_bytes, Load().summary.scene_bytes);
  options.region.bounding_box->translate(Eigen::Vector3d(0, 0, 100));
  EXPECT_THAT(ErrorOf(options), HasSubstr("usable views"));
}

TEST_F(LoadSceneTest, MissingMask) {
  fs::remove(MaskPath(3));
  fs::remove(MaskPath(7));
  EXPECT_THAT(ErrorOf(), HasSubstr("3.png.png: no such mask"));
  EXPECT_THAT(ErrorOf(), HasSubstr("2 of 12"));
  EXPECT_THAT(ErrorOf(), HasSubstr("--skip_missing_masks"));
  LoadSceneOptions options;
  options.skip_missing_masks = true;
  const LoadedScene loaded = Load(options);
  EXPECT_EQ(loaded.summary.num_views, 10u);
  EXPECT_EQ(loaded.summary.num_missing_masks, 2u);
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_THAT(recorder_.warnings[0], HasSubstr("2 of 12"));
  for (int i = 0; i < 10; ++i) {
    fs::remove(MaskPath(i));
  }
  EXPECT_THAT(ErrorOf(options), HasSubstr("2 usable views of 12"));
}

TEST_F(LoadSceneTest, MissingImage) {
  fs::remove(folder_ / "images" / "5.png");
  EXPECT_THAT(ErrorOf(), HasSubstr("5.png: no such image"));
  LoadSceneOptions options;
  options.skip_missing_images = true;
  EXPECT_EQ(Load(options).summary.num_views, 11u);
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_THAT(recorder_.warnings[0], HasSubstr("1 of 12"));
}

TEST_F(LoadSceneTest, ImageOfAnotherSize) {
  WritePicture(folder_ / "images" / "4.png", Texture(160, 120));
  EXPECT_THAT(ErrorOf(),
              HasSubstr("4.png: the image has 160x120 pixels, but "
                        "its camera 1 has 320x240"));
  // A format whose header is not read beforehand.
  cv::imwrite((folder_ / "x.bmp").string(), Texture(160, 120));
  fs::rename(folder_ / "x.bmp", folder_ / "images" / "4.png");
  EXPECT_THAT(ErrorOf(), HasSubstr("4.png: the image has 160x120 pixels"));
}

TEST_F(LoadSceneTest, UnreadableImage) {
  WriteText(folder_ / "images" / "4.png", "no picture");
  EXPECT_THAT(ErrorOf(), HasSubstr("4.png"));
}

TEST_F(LoadSceneTest, MaskWithoutObjectOrBackground) {
  WritePicture(MaskPath(2), cv::Mat::zeros(240, 320, CV_8UC1));
  EXPECT_THAT(ErrorOf(), HasSubstr("2.png.png: the mask is all background"));
  WritePicture(MaskPath(2), cv::Mat(240, 320, CV_8UC1, cv::Scalar(255)));
  EXPECT_THAT(ErrorOf(), HasSubstr("2.png.png: the mask is all object"));
}

TEST_F(LoadSceneTest, MaskOfAnotherGeometry) {
  WritePicture(MaskPath(2), cv::Mat::eye(120, 160, CV_8UC1));
  EXPECT_THAT(ErrorOf(), HasSubstr("2.png.png: the mask has 160x120 pixels"));
}

TEST_F(LoadSceneTest, InvertedMasks) {
  for (int i = 0; i < kNumImages; ++i) {
    cv::Mat mask = SphereMask(kRadial, RingPose(i, kNumImages), 0.8);
    WritePicture(MaskPath(i), 255 - mask);
  }
  EXPECT_THAT(ErrorOf(), HasSubstr("bounding_box"));
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_THAT(recorder_.warnings[0], HasSubstr("12 of 12"));
  EXPECT_THAT(recorder_.warnings[0], HasSubstr("inverted"));
}

// Beside the sphere by its radius.
cv::Mat ShiftedMask(int i) {
  const cv::Mat mask = SphereMask(kRadial, RingPose(i, kNumImages), 0.8);
  cv::Mat shifted = cv::Mat::zeros(mask.size(), CV_8UC1);
  mask.colRange(60, 320).copyTo(shifted.colRange(0, 260));
  return shifted;
}

TEST_F(LoadSceneTest, LeavesOutAMaskThatContradictsTheOthers) {
  const Region right = Load().region;
  WritePicture(MaskPath(4), ShiftedMask(4));
  const LoadedScene loaded = Load();
  EXPECT_EQ(loaded.summary.num_views, 11u);
  ASSERT_EQ(loaded.summary.bad_views.views.size(), 1u);
  EXPECT_EQ(loaded.summary.bad_views.views[0].name, "4.png");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_THAT(recorder_.warnings[0], HasSubstr("4.png.png"));
  EXPECT_NEAR(loaded.region.cube.edge / right.cube.edge, 1, 0.05);
  for (const View& view : loaded.scene.views) {
    EXPECT_NE(view.name, "4.png");
  }
  LoadSceneOptions options;
  options.region.bounding_box = {Eigen::Vector3d(-0.9, -0.9, -0.9),
                                 Eigen::Vector3d(0.9, 0.9, 0.9)};
  EXPECT_EQ(Load(options).summary.num_views, 11u);
  options.keep_all_views = true;
  EXPECT_EQ(Load(options).summary.num_views, 12u);
}

TEST_F(LoadSceneTest, RightMasksHaveNoBites) {
  LoadSceneOptions options;
  options.fill_bites = true;
  const LoadedScene loaded = Load(options);
  EXPECT_EQ(loaded.summary.num_filled_bites, 0u);
  ExpectSphere(loaded);
}

TEST(FilledBites, AreThoseOfTheSameLinesOfSight) {
  const PinholeCamera reduced = {20, 10, 10, 10, 10, 5};
  const PinholeCamera full = {30, 20, 20, 20, 15, 8};
  cv::Mat pixels = cv::Mat::zeros(10, 20, CV_8UC1);
  pixels.at<uint8_t>(5, 10) = 255;
  cv::Mat mask = cv::Mat::zeros(20, 30, CV_8UC1);
  FilledBites bites;
  bites.Fill(full, &mask);
  EXPECT_EQ(cv::countNonZero(mask), 0);
  bites.Add(reduced, pixels);
  bites.Fill(full, &mask);
  EXPECT_EQ(cv::countNonZero(mask), 4);
  EXPECT_EQ(cv::countNonZero(mask(cv::Rect(15, 8, 2, 2))), 4);
}

TEST_F(LoadSceneTest, RefusesManyMasksThatContradictTheOthers) {
  WritePicture(MaskPath(4), ShiftedMask(4));
  WritePicture(MaskPath(9), ShiftedMask(9));
  EXPECT_THAT(ErrorOf(), HasSubstr("2 of 12 views contradict the others"));
  EXPECT_THAT(ErrorOf(), HasSubstr("9.png.png"));
}

TEST_F(LoadSceneTest, UsesTheListedImagesAlone) {
  LoadSceneOptions options;
  options.workspace.image_list_path = folder_ / "list.txt";
  WriteText(options.workspace.image_list_path,
            "0.png\n2.png\n4.png\n6.png\n8.png\n");
  const LoadedScene loaded = Load(options);
  ASSERT_EQ(loaded.scene.views.size(), 5u);
  EXPECT_EQ(loaded.scene.views[1].name, "2.png");
  WriteText(options.workspace.image_list_path, "0.png\nnone.png\n");
  EXPECT_THAT(ErrorOf(options), HasSubstr("list.txt:2: none.png"));
}

TEST_F(LoadSceneTest, TooFewImages) {
  WriteSparseModelBinary(RingModel(kRadial, 2), folder_ / "sparse" / "0");
  EXPECT_THAT(ErrorOf(), HasSubstr("2 usable views of 2 images"));
}

TEST(LoadSceneOptions, RejectsBadValues) {
  EXPECT_NO_THROW(LoadSceneOptions().Check());
  LoadSceneOptions options;
  options.decode_budget = 0;
  EXPECT_THROW(options.Check(), OptionError);
  EXPECT_THROW(LoadScene(".", {}, 0, Context(1)), OptionError);
  EXPECT_THROW(LoadScene(".", {}, 21, Context(1)), OptionError);
}

}  // namespace
}  // namespace octacut
