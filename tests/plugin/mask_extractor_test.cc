// mask_extractor as a user meets it, and what octahedral_mesher makes of its
// masks.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_io/files/read_file.h"
#include "tests/colmap_io/images/tiny_network.h"
#include "tests/plugin/small_workspace.h"

namespace octacut::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class MaskExtractorTest : public SmallWorkspaceTest {
 protected:
  fs::path Found(int view) const { return Extracted() / Mask(view).filename(); }
  fs::path Extracted() const { return folder_ / "found"; }

  ProgramResult Extract(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"mask_extractor",
                                          "--workspace_path",
                                          Workspace().string(),
                                          "--output_path",
                                          Extracted().string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunOctacut(arguments);
  }
  nlohmann::json List() const {
    return nlohmann::json::parse(ReadFile(Extracted() / "masks.json"));
  }
  static double Overlap(const fs::path& a, const fs::path& b) {
    const cv::Mat mask_a = cv::imread(a.string(), cv::IMREAD_GRAYSCALE) > 127;
    const cv::Mat mask_b = cv::imread(b.string(), cv::IMREAD_GRAYSCALE) > 127;
    return double(cv::countNonZero(mask_a & mask_b)) /
           cv::countNonZero(mask_a | mask_b);
  }
};

TEST_F(MaskExtractorTest, FindsTheSilhouettes) {
  const ProgramResult result = Extract();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("12 masks, 0 given, 0 views unsure"));
  for (int i = 0; i < kSmallViews; ++i) {
    EXPECT_GT(Overlap(Found(i), Mask(i)), 0.96) << i;
  }
  const nlohmann::json list = List();
  ASSERT_EQ(list["views"].size(), size_t(kSmallViews));
  EXPECT_EQ(list["views"][3]["image"], "view_003.jpg");
  EXPECT_EQ(list["views"][3]["status"], "extracted");
  EXPECT_GT(list["views"][3]["confidence"], 0.5);
  EXPECT_FALSE(
      cv::imread((Extracted() / "contact_sheet.jpg").string()).empty());
}

// Salient is what is warmer than the background, which is bluish: red less blue
// in [0, 1], undone what the network gets normalised.
TinyNetwork WarmThings(float sharpness) {
  return {.weights = {sharpness * 0.229f, 0, -sharpness * 0.225f},
          .bias = sharpness * (0.485f - 0.406f)};
}

TEST_F(MaskExtractorTest, ANetworkProposesTheObject) {
  const fs::path path = folder_ / "warm.onnx";
  folder_.Write(path.filename(), OnnxWriter::Write(WarmThings(60)));
  const ProgramResult result = Extract({"--network_path", path.string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err,
              HasSubstr("The network proposes an object in 12 of 12 "
                        "photographs (48 x 32 pixels)."));
  for (int i = 0; i < kSmallViews; ++i) {
    EXPECT_GT(Overlap(Found(i), Mask(i)), 0.96) << i;
  }
}

TEST_F(MaskExtractorTest, NetworksThatFindNothingOrAreNoneAreNamed) {
  const fs::path path = folder_ / "n.onnx";
  folder_.Write(path.filename(), OnnxWriter::Write({.bias = -20}));
  EXPECT_THAT(Extract({"--network_path", path.string()}).err,
              HasSubstr("finds no object in any photograph"));
  folder_.Write(path.filename(), OnnxWriter::Write({.num_outputs = 2}));
  EXPECT_THAT(Extract({"--network_path", path.string()}).err,
              HasSubstr("1 x 2 x 32 x 48"));
  folder_.Write(path.filename(), "junk");
  EXPECT_THAT(Extract({"--network_path", path.string()}).err,
              HasSubstr("n.onnx"));
  EXPECT_THAT(Extract({"--network_path", folder_.Path().string()}).err,
              HasSubstr(folder_.Path().string() + ": the file cannot be read"));
  EXPECT_FALSE(fs::exists(Extracted()));
}

TEST_F(MaskExtractorTest, SameBytesForAnyNumberOfThreads) {
  ASSERT_EQ(Extract({"--num_threads", "1"}).exit_code, 0);
  const std::string mask = ReadFile(Found(5));
  const std::string list = ReadFile(Extracted() / "masks.json");
  ASSERT_EQ(Extract({"--num_threads", "3"}).exit_code, 0);
  EXPECT_EQ(ReadFile(Found(5)), mask);
  EXPECT_EQ(ReadFile(Extracted() / "masks.json"), list);
}

TEST_F(MaskExtractorTest, MasksThatTheUserChangedStay) {
  ASSERT_EQ(Extract().exit_code, 0);
  cv::Mat edited = cv::imread(Found(4).string(), cv::IMREAD_GRAYSCALE);
  edited(cv::Rect(0, 0, 10, 10)).setTo(255);
  cv::imwrite(Found(4).string(), edited);
  const std::string bytes = ReadFile(Found(4));
  const ProgramResult again = Extract();
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(ReadFile(Found(4)), bytes);
  EXPECT_THAT(again.out, HasSubstr("11 masks, 1 given"));
  EXPECT_EQ(List()["views"][4]["status"], "given");
}

TEST_F(MaskExtractorTest, GivenMasksAreKept) {
  const fs::path given = folder_ / "given";
  fs::create_directories(given);
  fs::copy(Mask(2), given / "view_002_mask.png");
  const ProgramResult result = Extract({"--given_masks_path", given});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Overlap(Found(2), Mask(2)), 1);
  EXPECT_EQ(List()["views"][2]["status"], "given");
  // The user has changed the mask in the folder, and gives another one.
  fs::copy(Mask(3), Found(2), fs::copy_options::overwrite_existing);
  const std::string bytes = ReadFile(Found(2));
  EXPECT_THAT(Extract({"--given_masks_path", given}).err,
              HasSubstr("view_002.jpg.png: both are the mask of image "
                        "view_002.jpg and differ; remove one"));
  EXPECT_EQ(ReadFile(Found(2)), bytes);
}

// A view with a lens cap on: no mask, named, and left out by the mesher.
TEST_F(MaskExtractorTest, UnsureViewsGetNoMask) {
  cv::imwrite(Image(6).string(),
              cv::Mat(kSmallHeight, kSmallWidth, CV_8UC3, cv::Scalar::all(9)));
  const ProgramResult result = Extract();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("11 masks, 0 given, 1 views unsure"));
  EXPECT_FALSE(fs::exists(Found(6)));
  EXPECT_EQ(List()["views"][6]["status"], "unsure");
  EXPECT_THAT(List()["views"][6]["doubt"].get<std::string>(),
              Not(::testing::IsEmpty()));
  const ProgramResult mesh = RunCut({"--mask_path", Extracted()});
  EXPECT_EQ(mesh.exit_code, 0) << mesh.err;
  EXPECT_THAT(mesh.err, HasSubstr("1 of 12 images are left out"));
  // Any other mask that is not there is still an error.
  fs::remove(Found(7));
  EXPECT_THAT(RunCut({"--mask_path", Extracted()}).err,
              HasSubstr("view_007.jpg.png: no such mask; missing for 1"));
}

TEST_F(MaskExtractorTest, StrokesAreKeptToThePixel) {
  const cv::Mat truth = cv::imread(Mask(2).string(), cv::IMREAD_GRAYSCALE);
  const cv::Rect box = cv::boundingRect(truth);
  const cv::Rect object(box.x - 3, box.y + box.height / 2, 40, 5);
  const cv::Rect background(box.br().x - 5, box.y + box.height / 2, 3, 7);
  cv::Mat strokes(truth.size(), CV_8U, cv::Scalar(128));
  strokes(object).setTo(255);
  strokes(background).setTo(0);
  fs::create_directories(folder_ / "strokes");
  cv::imwrite((folder_ / "strokes" / Mask(2).filename()).string(), strokes);
  const ProgramResult result = Extract({"--strokes_path", folder_ / "strokes"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const cv::Mat found = cv::imread(Found(2).string(), cv::IMREAD_GRAYSCALE);
  EXPECT_EQ(cv::countNonZero(found(object) != 255), 0);
  EXPECT_EQ(cv::countNonZero(found(background)), 0);
  EXPECT_GT(Overlap(Found(2), Mask(2)), 0.95);
}

// In one view, a patch beside the object continues its colours: in the
// photograph alone, the border is at the far end of the patch.
TEST_F(MaskExtractorTest, WhatTheOtherViewsExcludeIsBackground) {
  const cv::Mat truth =
      cv::imread(Mask(5).string(), cv::IMREAD_GRAYSCALE) > 127;
  cv::Mat image = cv::imread(Image(5).string());
  const cv::Rect box = cv::boundingRect(truth);
  std::vector<cv::Point> outermost;
  cv::findNonZero(truth.col(box.br().x - 1), outermost);
  const int row = outermost.front().y;
  for (int x = box.br().x; x < box.br().x + 25; ++x) {
    image(cv::Rect(2 * box.br().x - x - 6, row - 6, 1, 12))
        .copyTo(image(cv::Rect(x, row - 6, 1, 12)));
  }
  cv::imwrite(Image(5).string(), image);
  const ProgramResult result = Extract();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const cv::Mat found = cv::imread(Found(5).string(), cv::IMREAD_GRAYSCALE);
  cv::Mat near;
  cv::dilate(truth, near, cv::Mat::ones(11, 11, CV_8U));
  EXPECT_EQ(cv::countNonZero(found & ~near), 0);
  EXPECT_GT(Overlap(Found(5), Mask(5)), 0.96);
}

TEST_F(MaskExtractorTest, MesherMakesTheMasksIfAsked) {
  fs::remove_all(Workspace() / "masks");
  EXPECT_THAT(RunCut().err,
              HasSubstr("octacut mask_extractor --workspace_path"));
  const ProgramResult result = RunCut({"--extract_masks", "1"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(fs::exists(Mask(0)));
  EXPECT_THAT(result.out, HasSubstr("genus 1"));
}

TEST_F(MaskExtractorTest, MistakesAreNamedAndLeaveNothing) {
  const auto error = [&](const std::vector<std::string>& options) {
    const ProgramResult result = Extract(options);
    EXPECT_EQ(result.exit_code, 1);
    return result.err;
  };
  EXPECT_THAT(RunOctacut({"mask_extractor",
                          "--workspace_path",
                          Workspace().string(),
                          "--output_path",
                          Image(0).parent_path().string()})
                  .err,
              HasSubstr("must not be the folder of the photographs"));
  EXPECT_THAT(error({"--given_masks_path", folder_ / "nowhere"}),
              HasSubstr("given_masks_path"));
  fs::create_directories(folder_ / "empty");
  EXPECT_THAT(error({"--strokes_path", folder_ / "empty"}),
              HasSubstr("no file in the folder is named after an image"));
  EXPECT_THAT(error({"--OctahedralMeshing.bounding_box", "90,90,90,91,91,91"}),
              HasSubstr("bounding_box"));
  cv::imwrite(Image(1).string(), cv::Mat(20, 30, CV_8UC3, cv::Scalar::all(9)));
  EXPECT_THAT(error({}), HasSubstr("view_001.jpg: the image has 30x20"));
  EXPECT_FALSE(fs::exists(Extracted()));
}

TEST_F(MaskExtractorTest, TwoMasksOfOneImageMayNotDiffer) {
  fs::copy(Mask(3), Workspace() / "masks" / "mask_view_003.png");
  EXPECT_EQ(RunCut().exit_code, 0);
  fs::copy(Mask(4), Workspace() / "masks" / "view_003_mask.png");
  const ProgramResult result = RunCut();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("view_003.jpg.png and "));
  EXPECT_THAT(result.err, HasSubstr("view_003_mask.png: both are the mask"));
}

TEST_F(MaskExtractorTest, MaskComparerMeasuresThem) {
  ASSERT_EQ(Extract().exit_code, 0);
  fs::remove(Found(0));
  const auto compare = [&](const fs::path& masks, const fs::path& report) {
    return RunOctacut({"mask_comparer",
                       "--mask_path",
                       masks,
                       "--reference_path",
                       Workspace() / "masks",
                       "--output_path",
                       report});
  };
  const ProgramResult result = compare(Extracted(), folder_ / "masks.json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("1 of 12 masks are missing"));
  const nlohmann::json report =
      nlohmann::json::parse(ReadFile(folder_ / "masks.json"));
  EXPECT_FALSE(report["masks"][0]["is_there"]);
  EXPECT_GT(report["mean"]["overlap"], 0.96);
  EXPECT_LT(report["mean"]["border_mean"], 1);
  EXPECT_THAT(compare(folder_ / "gone", folder_ / "masks.json").err,
              HasSubstr("gone: no such folder"));
  const fs::path mask = Workspace() / "masks" / "view_003.jpg.png";
  const std::string before = ReadFile(mask);
  EXPECT_THAT(compare(Extracted(), mask).err,
              HasSubstr("must not be the same file as a reference mask"));
  EXPECT_EQ(ReadFile(mask), before);
}

}  // namespace
}  // namespace octacut::testing
