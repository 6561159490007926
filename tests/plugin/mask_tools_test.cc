// mask_renderer, mask_undistorter, and mask_extractor before the mapper.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_io/files/read_file.h"
#include "colmap_io/images/image_file.h"
#include "tests/plugin/small_workspace.h"

namespace octacut::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

double OverlapOf(const cv::Mat& a, const cv::Mat& b) {
  return double(cv::countNonZero((a > 127) & (b > 127))) /
         cv::countNonZero((a > 127) | (b > 127));
}

class MaskToolsTest : public SmallWorkspaceTest {
 protected:
  ProgramResult Render(const fs::path& output) const {
    return RunOctacut({"mask_renderer",
                       "--workspace_path",
                       Workspace(),
                       "--mesh_path",
                       Workspace() / "gt" / "reference.ply",
                       "--output_path",
                       output});
  }
  ProgramResult Undistort(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {
        "mask_undistorter", "--workspace_path", Workspace()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunOctacut(arguments);
  }
};

TEST_F(MaskToolsTest, RendererGivesTheSilhouettes) {
  const fs::path output = folder_ / "rendered";
  for (int run = 0; run < 2; ++run) {  // its own masks may be replaced
    const ProgramResult result = Render(output);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("12 masks, 0 of them empty"));
  }
  for (int i = 0; i < kSmallViews; ++i) {
    EXPECT_GT(
        OverlapOf(ReadGrey(output / Mask(i).filename()), ReadGrey(Mask(i))),
        0.995);
  }
  // Masks that it did not make stay.
  const std::string bytes = ReadFile(Mask(0));
  const ProgramResult refused = Render(Workspace() / "masks");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("view_000.jpg.png was not made by"));
  EXPECT_EQ(ReadFile(Mask(0)), bytes);
  cv::imwrite((output / "view_003.jpg.png").string(),
              cv::Mat(20, 30, CV_8U, cv::Scalar(0)));
  EXPECT_THAT(Render(output).err, HasSubstr("view_003.jpg.png was not made"));
  // Nor do those in a folder that a link leads to.
  fs::create_directories(folder_ / "linking");
  fs::create_directory_symlink(Workspace() / "masks",
                               folder_ / "linking" / "cam1");
  EXPECT_THAT(Render(folder_ / "linking").err, HasSubstr("was not made by"));
}

TEST_F(MaskToolsTest, UndistorterGivesMasksOfUndistortedImages) {
  fs::remove_all(Workspace());
  const ProgramResult example = RunOctacut({"example_creator",
                                            "--output_path",
                                            Workspace(),
                                            "--scene",
                                            "sphere",
                                            "--num_views",
                                            "4",
                                            "--width",
                                            "240",
                                            "--height",
                                            "180",
                                            "--Rig.k1",
                                            "0.2",
                                            "--Rig.fill",
                                            "0.6",
                                            "--reference_resolution",
                                            "40"});
  ASSERT_EQ(example.exit_code, 0) << example.err;
  const fs::path output = folder_ / "undistorted";
  std::ofstream(Workspace() / "masks" / "masks.json")
      << R"({"program": "octacut mask_extractor", "mode": "turntable", "views": []})";
  const ProgramResult result = Undistort({"--output_path", output});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(ReadFile(output / "masks.json"), HasSubstr("turntable"));
  const cv::Mat original = ReadGrey(Mask(1));
  const cv::Mat mask = ReadGrey(output / "view_001.jpg.png");
  // The sphere's silhouette is a disc of 0.6 * 180 pixels only without the
  // distortion, which enlarges it by k1 r^2; COLMAP cuts the frame's borders.
  EXPECT_LT(mask.cols, original.cols + 1);
  const double radius = 0.3 * 180;
  EXPECT_NEAR(cv::sum(mask)[0] / 255, M_PI * radius * radius, 40);
  EXPECT_GT(cv::sum(original)[0] / 255, M_PI * radius * radius + 60);

  EXPECT_THAT(Undistort({"--output_path", Workspace() / "masks"}).err,
              HasSubstr("this is the folder of the original masks"));
  EXPECT_THAT(Undistort({"--output_path",
                         output,
                         "--undistorted_path",
                         Workspace() / "sparse" / "0"})
                  .err,
              HasSubstr("has a distortion"));
  fs::remove(Mask(2));
  EXPECT_THAT(Undistort({"--output_path", output}).err,
              HasSubstr("view_002.jpg.png: no such mask"));
}

class TurntableModeTest : public SmallWorkspaceTest {
 protected:
  TurntableModeTest() {
    fs::remove_all(Workspace());
    const ProgramResult example = RunOctacut({"example_creator",
                                              "--output_path",
                                              Workspace(),
                                              "--scene",
                                              "lump",
                                              "--num_views",
                                              "12",
                                              "--width",
                                              "240",
                                              "--height",
                                              "180",
                                              "--Rig.kind",
                                              "turntable",
                                              "--Rig.min_elevation",
                                              "25",
                                              "--Scene.stand",
                                              "1",
                                              "--reference_resolution",
                                              "40"});
    EXPECT_EQ(example.exit_code, 0) << example.err;
  }
  ProgramResult Extract(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {"mask_extractor"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunOctacut(arguments);
  }
  ProgramResult ExtractTurning(std::vector<std::string> options = {}) const {
    options.insert(options.end(),
                   {"--mode",
                    "turntable",
                    "--image_path",
                    Workspace() / "images",
                    "--output_path",
                    Turning()});
    return Extract(options);
  }
  fs::path Turning() const { return folder_ / "turning"; }
};

TEST_F(TurntableModeTest, MasksOfWhatTurnsLeadToMasksOfTheObject) {
  const ProgramResult turning = ExtractTurning();
  ASSERT_EQ(turning.exit_code, 0) << turning.err;
  EXPECT_THAT(turning.out, HasSubstr("12 masks, 0 given, 0 views unsure"));
  for (int i = 0; i < kSmallViews; ++i) {
    const cv::Mat found = ReadGrey(Turning() / Mask(i).filename()) > 127;
    const cv::Mat object = ReadGrey(Mask(i)) > 127;
    const int missed = cv::countNonZero(object & ~found);
    EXPECT_LT(missed, 0.03 * cv::countNonZero(object)) << i;
    // The background at the top stays outside.
    EXPECT_EQ(cv::countNonZero(found.rowRange(0, 3)), 0);
  }
  // After the mapper: without the plate.
  const fs::path found = folder_ / "found";
  const ProgramResult result = Extract({"--workspace_path",
                                        Workspace(),
                                        "--output_path",
                                        found,
                                        "--strokes_path",
                                        Turning(),
                                        "--on_stand",
                                        "1"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("The object stands on a plane that"));
  for (int i = 0; i < kSmallViews; ++i) {
    EXPECT_GT(
        OverlapOf(ReadGrey(found / Mask(i).filename()), ReadGrey(Mask(i))),
        0.96)
        << i;
  }
}

TEST_F(TurntableModeTest, PhotographsOfTheEmptySetAreUsed) {
  const ProgramResult result =
      ExtractTurning({"--background_path", Workspace() / "background"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const cv::Mat found = ReadGrey(Turning() / Mask(5).filename()) > 127;
  const cv::Mat object = ReadGrey(Mask(5)) > 127;
  EXPECT_LT(cv::countNonZero(object & ~found), 0.03 * cv::countNonZero(object));
}

TEST_F(TurntableModeTest, FoldersOfMasksAndBackgroundAreNoPhotographs) {
  const fs::path images = Workspace() / "images";
  fs::copy(Workspace() / "background", images / "empty");
  for (int run = 0; run < 2; ++run) {
    const ProgramResult result = Extract({"--mode",
                                          "turntable",
                                          "--image_path",
                                          images,
                                          "--background_path",
                                          images / "empty",
                                          "--output_path",
                                          images / "masks"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("12 masks, 0 given, 0 views unsure"));
  }
}

TEST_F(TurntableModeTest, MistakesAreNamedAndLeaveNothing) {
  EXPECT_THAT(Extract({"--mode", "turntable"}).err, HasSubstr("image_path"));
  EXPECT_THAT(Extract({}).err, HasSubstr("workspace_path"));
  EXPECT_THAT(ExtractTurning({"--on_stand", "1"}).err, HasSubstr("on_stand"));
  EXPECT_THAT(Extract({"--workspace_path", Workspace(), "--on_stand", "2"}).err,
              HasSubstr("on_stand = 2: must be -1, 0 or 1"));
  EXPECT_THAT(ExtractTurning({"--background_path", folder_ / "none"}).err,
              HasSubstr("no such folder"));
  fs::create_directories(Turning());
  cv::imwrite((Turning() / "view_004.jpg.png").string(),
              cv::Mat(7, 10, CV_8U, cv::Scalar::all(255)));
  EXPECT_THAT(ExtractTurning().err,
              HasSubstr("view_004.jpg.png: the mask has 10x7 pixels, but its "
                        "photograph 240x180"));
  fs::remove_all(Turning());
  // All photographs show the same view.
  for (int i = 1; i < kSmallViews; ++i) {
    fs::copy_file(Image(0), Image(i), fs::copy_options::overwrite_existing);
  }
  EXPECT_THAT(ExtractTurning().err, HasSubstr("all 12 show the same"));
  cv::imwrite(Image(4).string(), cv::Mat(20, 30, CV_8UC3, cv::Scalar::all(9)));
  EXPECT_THAT(ExtractTurning().err,
              HasSubstr("view_004.jpg: the image has 30x20"));
  for (int i = 2; i < kSmallViews; ++i) {
    fs::remove(Image(i));
  }
  EXPECT_THAT(ExtractTurning().err, HasSubstr("2 photographs; at least 3"));
  EXPECT_FALSE(fs::exists(Turning()));
}

}  // namespace
}  // namespace octacut::testing
