// Models that COLMAP itself wrote, where the shared data is there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "colmap_io/model/camera_projector.h"
#include "colmap_io/model/read_sparse_model.h"
#include "tests/colmap_io/model/test_models.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;

class SharedDataTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto data = SharedData();
    if (!data || !std::filesystem::is_directory(*data / "colmap_models")) {
      GTEST_SKIP() << "the shared data is not there (OCTACUT_SHARED_DATA)";
    }
    data_ = *data;
    models_ = *data / "colmap_models";
  }
  std::filesystem::path data_;
  std::filesystem::path models_;
};

// Mean distance of a point's observations to where our cameras project it.
double ReprojectionError(const SparseModel& model, const SparsePoint& point) {
  double sum = 0;
  for (const TrackElement& element : point.track) {
    const auto image = std::find_if(
        model.images.begin(), model.images.end(), [&](const auto& i) {
          return i.id == element.image_id;
        });
    const auto pixel = CameraProjector(*model.FindCamera(image->camera_id))
                           .ImgFromCam(image->CamFromWorld() * point.xyz);
    if (!pixel) return -1;
    const SparseObservation& seen = image->observations[element.point2D_index];
    sum += (*pixel - Eigen::Vector2d(seen.x, seen.y)).norm();
  }
  return sum / double(point.track.size());
}

// COLMAP's own errors are reproduced: poses, observations, tracks and the
// projection are all what they were.
void ExpectColmapsErrors(const SparseModel& model) {
  ASSERT_GT(model.points.size(), 100u);
  const size_t stride = model.points.size() / 100;
  for (size_t i = 0; i < model.points.size(); i += stride) {
    ASSERT_NEAR(
        ReprojectionError(model, model.points[i]), model.points[i].error, 1e-6);
  }
}

void SortById(SparseModel* model) {
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  std::sort(model->images.begin(), model->images.end(), by_id);
  std::sort(model->points.begin(), model->points.end(), by_id);
}

// COLMAP wrote cameras and images with six digits then.
void ExpectSameButForDigits(const SparseModel& a, const SparseModel& b) {
  const auto near = [](double x, double y) {
    return std::abs(x - y) <= 1e-5 * std::max(1.0, std::abs(x));
  };
  ASSERT_EQ(a.cameras.size(), 1u);
  ASSERT_EQ(b.cameras.size(), 1u);
  for (size_t i = 0; i < a.cameras[0].params.size(); ++i) {
    EXPECT_TRUE(near(a.cameras[0].params[i], b.cameras[0].params[i]));
  }
  ASSERT_EQ(a.images.size(), b.images.size());
  for (size_t i = 0; i < a.images.size(); ++i) {
    const SparseImage& x = a.images[i];
    const SparseImage& y = b.images[i];
    EXPECT_EQ(x.id, y.id);
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.camera_id, y.camera_id);
    EXPECT_LT((x.rotation.coeffs() - y.rotation.coeffs()).norm(), 1e-5);
    EXPECT_LT((x.translation - y.translation).norm(), 1e-4);
    ASSERT_EQ(x.observations.size(), y.observations.size());
    for (size_t j = 0; j < x.observations.size(); ++j) {
      ASSERT_TRUE(near(x.observations[j].x, y.observations[j].x));
      ASSERT_TRUE(near(x.observations[j].y, y.observations[j].y));
      ASSERT_EQ(x.observations[j].point3D_id, y.observations[j].point3D_id);
    }
  }
}

TEST_F(SharedDataTest, OldBinaryAndText) {
  const std::filesystem::path folder = models_ / "old_bin_and_txt/sparse/0";
  SparseModel binary = ReadSparseModel(folder);
  EXPECT_EQ(CountSparseImages(folder), binary.images.size());
  // The text alone, from another folder.
  const TemporaryFolder copy;
  for (const char* file : {"cameras.txt", "images.txt", "points3D.txt"}) {
    std::filesystem::copy_file(folder / file, copy / file);
  }
  SparseModel text = ReadSparseModel(copy.Path());
  SortById(&binary);
  SortById(&text);
  ExpectSameButForDigits(binary, text);
  ExpectSamePoints(binary, text);
}

TEST_F(SharedDataTest, NewWithRigsAndFrames) {
  const SparseModel binary =
      ReadSparseModel(models_ / "new_bin_with_rigs/sparse/0");
  const SparseModel text =
      ReadSparseModel(models_ / "new_bin_with_rigs/sparse");
  EXPECT_EQ(binary.images.size(), 7u);
  EXPECT_EQ(text.images.size(), 7u);
  EXPECT_EQ(text.points.size(), 495u);
}

TEST_F(SharedDataTest, NamesOfOtherAlphabets) {
  const SparseModel model =
      ReadSparseModel(models_ / "new_bin_non_ascii_names/sparse/0");
  ASSERT_FALSE(model.images.empty());
  bool non_ascii = false;
  for (const SparseImage& image : model.images) {
    for (char c : image.name) non_ascii |= (c & 0x80) != 0;
  }
  EXPECT_TRUE(non_ascii);
}

TEST_F(SharedDataTest, IncompleteIsRefused) {
  for (const char* model : {"0", "1"}) {
    EXPECT_THAT(
        InputErrorOf([&] {
          ReadSparseModel(models_ / "incomplete_without_images/sparse" / model);
        }),
        HasSubstr("images.bin missing"));
  }
}

TEST_F(SharedDataTest, ErrorsOfColmapsMapperAreReproduced) {
  ExpectColmapsErrors(ReadSparseModel(data_ / "temple/sparse/0"));
}

TEST_F(SharedDataTest, HandMadeTextModels) {
  for (const char* folder : {"dino/sparse/0",
                             "bunny/sparse/0",
                             "igea/sparse_gt",
                             "rocker/sparse_gt"}) {
    SCOPED_TRACE(folder);
    const SparseModel model = ReadSparseModel(data_ / folder);
    EXPECT_GE(model.images.size(), 16u);
    EXPECT_TRUE(model.points.empty());
  }
}

}  // namespace
}  // namespace octacut
