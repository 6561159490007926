// What a workspace can have wrong, as a user meets it: one line that names
// file, field and value, exit code 1, earlier results as they were.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_io/files/read_file.h"
#include "plugin/report.h"
#include "tests/plugin/small_workspace.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kSmallHeight;
using testing::kSmallViews;
using testing::kSmallWidth;

constexpr int32_t kOffsetOfModelId = 12;  // in cameras.bin: count, camera id

void WriteBytes(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

void KeepHalf(const fs::path& path) {
  const std::string bytes = ReadFile(path);
  WriteBytes(path, bytes.substr(0, bytes.size() / 2));
}

class InputErrors : public testing::SmallWorkspaceTest {
 protected:
  void ExpectError(const std::string& message,
                   const std::vector<std::string>& options = {}) {
    const std::vector<fs::path> results = {
        Workspace() / "meshed-octahedral.ply",
        Workspace() / "meshed-octahedral.json",
        Workspace() / "meshed-octahedral.png"};
    for (const fs::path& path : results) {
      WriteBytes(path, "earlier");
    }
    const ProgramResult result = RunMesher(options);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.out, IsEmpty());
    const size_t begin = result.err.find("ERROR: ");
    ASSERT_NE(begin, std::string::npos) << result.err;
    const std::string error = result.err.substr(begin);
    EXPECT_THAT(error, HasSubstr(message));
    EXPECT_EQ(error.find('\n'), error.size() - 1) << error;
    for (const fs::path& path : results) {
      EXPECT_EQ(ReadFile(path), "earlier") << path;
    }
  }

  // Goes on, with one warning that says so and a report that counts.
  void ExpectWarning(const std::string& message,
                     const std::string& counter,
                     int count,
                     const std::vector<std::string>& options) {
    const ProgramResult result = RunCut(options);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("WARNING: "));
    EXPECT_THAT(result.err, HasSubstr(message));
    const Json report =
        Json::parse(ReadFile(Workspace() / "meshed-octahedral.json"));
    EXPECT_EQ(report["input"][counter], count);
    EXPECT_EQ(report["input"]["views"], kSmallViews - count);
    EXPECT_THAT(report["warnings"][0].get<std::string>(), HasSubstr(message));
  }

  void FillMask(int view,
                int value,
                cv::Size size = {kSmallWidth, kSmallHeight}) {
    ASSERT_TRUE(cv::imwrite(Mask(view).string(),
                            cv::Mat(size, CV_8UC1, cv::Scalar(value))));
  }

  void SetCameraModel(int32_t model) {
    std::string bytes = ReadFile(Model("cameras.bin"));
    std::memcpy(bytes.data() + kOffsetOfModelId, &model, sizeof(model));
    WriteBytes(Model("cameras.bin"), bytes);
  }

  const std::vector<std::string> skip_masks_ = {"--skip_missing_masks", "1"};
  const std::vector<std::string> skip_images_ = {"--skip_missing_images", "1"};
};

TEST_F(InputErrors, ImageOfAnotherSizeThanItsCamera) {
  cv::imwrite(Image(4).string(), cv::Mat::zeros(150, 200, CV_8UC3));
  ExpectError(
      fmt::format("view_004.jpg: the image has 200x150 pixels, but its camera "
                  "1 has {}x{}",
                  kSmallWidth,
                  kSmallHeight));
}

TEST_F(InputErrors, MissingImages) {
  fs::remove(Image(5));
  ExpectError("view_005.jpg: no such image; missing for 1 of 12 images");
  ExpectWarning(
      "missing for 1 of 12 images", "missing_images", 1, skip_images_);
}

TEST_F(InputErrors, UnreadableImages) {
  const std::string photograph = ReadFile(Image(3));
  for (const std::string& bytes :
       {std::string(),
        std::string("no picture"),
        photograph.substr(0, photograph.size() / 2)}) {
    WriteBytes(Image(3), bytes);
    ExpectError("view_003.jpg: ");
  }
}

TEST_F(InputErrors, MissingMasks) {
  fs::remove(Mask(3));
  fs::remove(Mask(8));
  ExpectError(
      "view_003.jpg.png: no such mask; missing for 2 of 12 images "
      "(--skip_missing_masks 1");
  ExpectWarning("missing for 2 of 12 images", "missing_masks", 2, skip_masks_);
  fs::remove_all(Workspace() / "masks");
  ExpectError("/masks: the folder of masks does not exist; use --mask_path");
}

TEST_F(InputErrors, MasksThatAreAllBackground) {
  FillMask(2, 0);
  ExpectError(
      "view_002.jpg.png: the mask is all background; 1 of 12 masks show no "
      "outline (--skip_missing_masks 1");
  ExpectWarning(
      "1 of 12 masks show no outline", "masks_without_outline", 1, skip_masks_);
}

TEST_F(InputErrors, MasksThatAreAllObject) {
  FillMask(2, 255);
  FillMask(7, 255);
  ExpectError("view_002.jpg.png: the mask is all object; 2 of 12 masks");
  ExpectWarning(
      "2 of 12 masks show no outline", "masks_without_outline", 2, skip_masks_);
}

TEST_F(InputErrors, MasksOfAnotherGeometry) {
  FillMask(2, 255, {100, 80});
  ExpectError("view_002.jpg.png: the mask has 100x80 pixels", skip_masks_);
}

TEST_F(InputErrors, UnreadableMasks) {
  const std::string mask = ReadFile(Mask(3));
  for (const std::string& bytes : {std::string(),
                                   std::string("no picture"),
                                   mask.substr(0, mask.size() / 2)}) {
    WriteBytes(Mask(3), bytes);
    ExpectError("view_003.jpg.png: ", skip_masks_);
  }
}

TEST_F(InputErrors, TooFewUsableViews) {
  for (int view = 0; view < kSmallViews - 2; ++view) {
    view % 2 == 0 ? FillMask(view, 0) : void(fs::remove(Mask(view)));
  }
  ExpectError("sparse/0: 2 usable views of 12 images; at least 3 are needed",
              skip_masks_);
}

TEST_F(InputErrors, TruncatedModels) {
  for (const char* name : {"cameras.bin", "images.bin", "points3D.bin"}) {
    const std::string whole = ReadFile(Model(name));
    KeepHalf(Model(name));
    ExpectError(std::string(name) + ": ");
    WriteBytes(Model(name), "");
    ExpectError(std::string(name) + ": ends within number of ");
    fs::remove(Model(name));
    ExpectError(std::string("incomplete sparse model: ") + name + " missing");
    WriteBytes(Model(name), whole);
  }
  fs::remove_all(Workspace() / "sparse");
  ExpectError(
      "/sparse: the folder of sparse models does not exist; use --input_path");
}

TEST_F(InputErrors, CameraModels) {
  SetCameraModel(99);
  ExpectError("cameras.bin: camera 1: camera model 99 is unknown");
  SetCameraModel(17);
  ExpectError("cameras.bin: camera 1: camera model EQUIRECTANGULAR (17)");
}

// What can be written is known before any work.
TEST_F(InputErrors, PathsThatCannotBeWritten) {
  const std::string gone = (folder_ / "gone").string();
  ExpectError("x.xyz: unknown mesh extension", {"--output_path", "x.xyz"});
  ExpectError("/gone/x.ply: cannot be written",
              {"--output_path", gone + "/x.ply"});
  ExpectError("/gone/x.json: cannot be written",
              {"--report_path", gone + "/x.json"});
  const std::string mesh = (Workspace() / "meshed-octahedral.ply").string();
  ExpectError("--report_path = " + mesh + ": must not be the same file",
              {"--report_path", mesh});
  const fs::path beside = Workspace() / "." / "meshed-octahedral.";
  ExpectError("must not be the same file as the mesh",
              {"--report_path", beside.string() + "ply"});
  ExpectError("must not be the same file as the picture",
              {"--report_path", beside.string() + "png"});
  ExpectError("must not be a .3mf file, whose units are millimetres",
              {"--output_path", (folder_ / "x.3mf").string()});
  fs::create_directories(folder_ / "other.png");
  ExpectError("other.png", {"--output_path", (folder_ / "other.ply").string()});
  WriteBytes(folder_ / "gone", "a file");
  ExpectError("save_levels " + gone, {"--save_levels", gone});
}

TEST_F(InputErrors, BoundingBoxes) {
  const std::string option = "--OctahedralMeshing.bounding_box";
  ExpectError(option + " = 1,2,3: must be six numbers", {option, "1,2,3"});
  ExpectError(option + " = 1,1,1,0,0,0: must be x0", {option, "1,1,1,0,0,0"});
  ExpectError("0 usable views of 12 images", {option, "90,90,90,99,99,99"});
}

// The search for the region would have named the mask.
TEST_F(InputErrors, MasksThatShowNothingOfABoundingBox) {
  cv::Mat mask = cv::Mat::zeros(kSmallHeight, kSmallWidth, CV_8UC1);
  mask(cv::Rect(1, 1, 4, 4)).setTo(255);
  ASSERT_TRUE(cv::imwrite(Mask(3).string(), mask));
  const ProgramResult left_out = RunCut({});
  EXPECT_EQ(left_out.exit_code, 0);
  EXPECT_THAT(left_out.err,
              HasSubstr("view_003.jpg.png: this mask or the pose of "
                        "view_003.jpg contradicts the other views"));
  const ProgramResult all = RunCut({"--keep_all_views", "1"});
  EXPECT_EQ(all.exit_code, 1);
  EXPECT_THAT(all.err, HasSubstr("all masks except that of view_003.jpg fit"));
  const ProgramResult result = RunCut({"--keep_all_views",
                                       "1",
                                       "--OctahedralMeshing.bounding_box",
                                       "-0.7,-0.7,-0.3,0.7,0.7,0.3"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err,
              HasSubstr("view_003.jpg.png: the mask shows no object within the "
                        "bounding box; this holds for 1 of 12 masks"));
  EXPECT_THAT(result.err, HasSubstr("ERROR: the visual hull is empty"));
}

}  // namespace
}  // namespace octacut
