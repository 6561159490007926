// Against the colmap executable, where it is installed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "colmap_io/model/camera_projector.h"
#include "colmap_io/model/read_sparse_model.h"
#include "colmap_io/model/write_sparse_model.h"
#include "tests/colmap_io/model/test_models.h"

namespace octacut {
namespace {

// What COLMAP 3.8 knows; later models are tested against their definitions.
constexpr int kLastModelOfColmap38 = camera_model::kThinPrismFisheye;

class ColmapTest : public ModelFolderTest {
 protected:
  void SetUp() override {
    if (std::system("command -v colmap > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "colmap is not installed";
    }
  }

  void RunColmap(const std::string& arguments) const {
    const std::string command =
        fmt::format("QT_QPA_PLATFORM=offscreen colmap {} > {} 2>&1",
                    arguments,
                    (folder_ / "colmap.log").string());
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }

  void Convert(const char* input, const char* output, const char* type) const {
    std::filesystem::create_directories(folder_ / output);
    RunColmap(fmt::format(
        "model_converter --input_path {} --output_path {} --output_type {}",
        (folder_ / input).string(),
        (folder_ / output).string(),
        type));
  }
};

// COLMAP writes in the order of its hash maps.
SparseModel Sorted(SparseModel model) {
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  std::sort(model.cameras.begin(), model.cameras.end(), by_id);
  std::sort(model.images.begin(), model.images.end(), by_id);
  std::sort(model.points.begin(), model.points.end(), by_id);
  return model;
}

void ExpectSameSorted(const SparseModel& a, const SparseModel& b) {
  ExpectSameCameras(Sorted(a), Sorted(b));
  // COLMAP normalizes quaternions whenever it reads them.
  ExpectSameImages(Sorted(a), Sorted(b), 1e-15);
  ExpectSamePoints(Sorted(a), Sorted(b));
}

SparseModel ModelForColmap38() {
  SparseModel model = TestModel(11, 20, 30);
  std::erase_if(model.cameras, [](const SparseCamera& camera) {
    return camera.model_id > kLastModelOfColmap38;
  });
  for (size_t i = 0; i < model.images.size(); ++i) {
    model.images[i].camera_id = model.cameras[i % model.cameras.size()].id;
    // COLMAP's text reader ends names at blanks.
    std::string& name = model.images[i].name;
    std::replace(name.begin(), name.end(), ' ', '_');
  }
  return model;
}

TEST_F(ColmapTest, ConvertsOurFilesAndWeReadThem) {
  const SparseModel model = ModelForColmap38();
  WriteSparseModelBinary(model, folder_ / "ours_bin");
  Convert("ours_bin", "bin_to_txt", "TXT");
  Convert("ours_bin", "bin_to_bin", "BIN");
  for (const char* converted : {"bin_to_txt", "bin_to_bin"}) {
    SCOPED_TRACE(converted);
    ExpectSameSorted(model, ReadSparseModel(folder_ / converted));
  }
}

// Every observation lies 5 pixels from where our projection puts its point;
// COLMAP, asked for the mean reprojection errors, must find the same.
TEST_F(ColmapTest, ProjectsAsWeDo) {
  SparseModel model;
  for (const SparseCamera& camera : TestCameras()) {
    if (camera.model_id > kLastModelOfColmap38) continue;
    const CameraProjector projector(camera);
    model.cameras.push_back(camera);
    const size_t first_image = model.images.size();
    for (uint32_t side = 0; side < 2; ++side) {
      SparseImage image;
      image.id = uint32_t(model.images.size() + 1);
      image.camera_id = camera.id;
      image.name = fmt::format("{}.png", image.id);
      image.translation = {side == 0 ? 0.2 : -0.2, 0.1, 0};
      model.images.push_back(image);
    }
    for (int x = 20; x < 640; x += 75) {
      for (int y = 15; y < 480; y += 75) {
        const auto ray = projector.CamFromImg({double(x), double(y)});
        ASSERT_TRUE(ray && ray->z() > 0.02);
        SparsePoint point;
        point.id = model.points.size() + 1;
        point.xyz = *ray / ray->z() * 100;
        for (size_t i = first_image; i < first_image + 2; ++i) {
          SparseImage& image = model.images[i];
          const auto pixel =
              projector.ImgFromCam(image.CamFromWorld() * point.xyz);
          if (!pixel) continue;
          point.track.push_back(
              {image.id, uint32_t(image.observations.size())});
          image.observations.push_back(
              {pixel->x() + 3, pixel->y() - 4, point.id});
        }
        ASSERT_EQ(point.track.size(), 2u);
        model.points.push_back(point);
      }
    }
  }
  WriteSparseModelBinary(model, folder_ / "in");
  std::filesystem::create_directories(folder_ / "out");
  RunColmap(
      fmt::format("point_filtering --input_path {} --output_path {} "
                  "--max_reproj_error 1000 --min_tri_angle 0",
                  (folder_ / "in").string(),
                  (folder_ / "out").string()));
  const SparseModel result = ReadSparseModel(folder_ / "out");
  ASSERT_EQ(result.points.size(), model.points.size());
  for (const SparsePoint& point : result.points) {
    ASSERT_NEAR(point.error, 5, 1e-7) << "point " << point.id;
  }
}

}  // namespace
}  // namespace octacut
