#include "colmap_io/model/camera_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "colmap_io/model/camera_projector.h"
#include "core/base/error.h"
#include "tests/colmap_io/model/test_models.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;

TEST(CameraModelTable, NamesAndCountsAgree) {
  for (int id = 0; id < camera_model::kCount; ++id) {
    const CameraModelInfo* info = FindCameraModel(id);
    ASSERT_NE(info, nullptr);
    EXPECT_EQ(info->id, id);
    EXPECT_EQ(FindCameraModel(info->name), info);
    const auto commas =
        std::count(info->params.begin(), info->params.end(), ',');
    EXPECT_EQ(commas + 1, info->num_params) << info->name;
    EXPECT_EQ(info->params.substr(0, 2),
              info->num_focal_lengths == 1 ? "f," : "fx");
  }
  EXPECT_EQ(FindCameraModel(-1), nullptr);
  EXPECT_EQ(FindCameraModel(17), nullptr);
  EXPECT_EQ(FindCameraModel("PINHOLES"), nullptr);
}

TEST(CameraModelTable, EveryModelIsTested) {
  std::vector<int> seen(camera_model::kCount, 0);
  for (const SparseCamera& camera : TestCameras()) ++seen[camera.model_id];
  for (int count : seen) EXPECT_GT(count, 0);
}

TEST(CheckCamera, RefusesByName) {
  EXPECT_THAT(InputErrorOf([] { RequireCameraModel(17, "a.bin: camera 3"); }),
              ::testing::AllOf(HasSubstr("a.bin: camera 3"),
                               HasSubstr("EQUIRECTANGULAR"),
                               HasSubstr("not a perspective camera")));
  EXPECT_THAT(
      InputErrorOf([] { RequireCameraModel("EQUIRECTANGULAR", "a.txt"); }),
      HasSubstr("not a perspective camera"));
  EXPECT_THAT(InputErrorOf([] { RequireCameraModel(99, "a.bin"); }),
              HasSubstr("camera model 99 is unknown"));
  EXPECT_THAT(InputErrorOf([] { RequireCameraModel("NIKON", "a.txt"); }),
              HasSubstr("\"NIKON\" is unknown"));
}

TEST(CheckCamera, NamesFileCameraFieldAndValue) {
  const SparseCamera good{7,
                          camera_model::kOpenCV,
                          640,
                          480,
                          {500, 505, 318, 243, -0.18, 0.05, 0.002, -0.003}};
  EXPECT_NO_THROW(CheckCamera(good, "cameras.txt"));
  const auto message = [&](auto change) {
    SparseCamera bad = good;
    change(bad);
    return InputErrorOf([&] { CheckCamera(bad, "cameras.txt"); });
  };
  EXPECT_EQ(
      message([](auto& c) { c.params[1] = -2; }),
      "cameras.txt: camera 7: OPENCV parameter fy = -2: must be positive");
  EXPECT_EQ(message([](auto& c) { c.params[0] = 0; }),
            "cameras.txt: camera 7: OPENCV parameter fx = 0: must be positive");
  EXPECT_THAT(message([](auto& c) { c.params[6] = NAN; }),
              HasSubstr("parameter p1 = nan: must be finite"));
  EXPECT_THAT(message([](auto& c) { c.params[2] = INFINITY; }),
              HasSubstr("parameter cx = inf: must be finite"));
  EXPECT_THAT(message([](auto& c) { c.params.pop_back(); }),
              HasSubstr("7 parameters, but OPENCV has 8"));
  EXPECT_THAT(message([](auto& c) { c.width = 0; }), HasSubstr("width = 0"));
  EXPECT_THAT(message([](auto& c) { c.height = 2147483647; }),
              HasSubstr("height = 2147483647: must be 1 to 1000000"));
  EXPECT_THAT(message([](auto& c) { c.height = 1ull << 31; }),
              HasSubstr("height = 2147483648"));
  EXPECT_THAT(message([](auto& c) { c.model_id = 17; }),
              HasSubstr("camera 7: camera model EQUIRECTANGULAR"));
  EXPECT_THAT(message([](auto& c) {
                c.model_id = camera_model::kEUCM;
                c.params = {500, 500, 320, 240, 1.5, 1};
              }),
              HasSubstr("EUCM parameter alpha = 1.5"));
  EXPECT_THAT(message([](auto& c) {
                c.model_id = camera_model::kFOV;
                c.params = {500, 500, 320, 240, 4};
              }),
              HasSubstr("FOV parameter omega = 4"));
}

// Every pixel has a ray, and that projects to the pixel again.
TEST(CameraModels, ProjectionInvertsOverTheWholeImage) {
  for (const SparseCamera& camera : TestCameras()) {
    SCOPED_TRACE(FindCameraModel(camera.model_id)->name);
    SCOPED_TRACE(camera.id);
    const CameraProjector projector(camera);
    for (int y = 0; y <= 480; y += 12) {
      for (int x = 0; x <= 640; x += 16) {
        const auto ray = projector.CamFromImg({x, y});
        ASSERT_TRUE(ray.has_value()) << x << " " << y;
        ASSERT_NEAR(ray->norm(), 1, 1e-12);
        const auto pixel = projector.ImgFromCam(*ray * 3.7);
        ASSERT_TRUE(pixel.has_value()) << x << " " << y;
        ASSERT_NEAR((*pixel - Eigen::Vector2d(x, y)).norm(), 0, 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace octacut
