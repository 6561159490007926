// The HTML pages of mesh_comparer and mesh_evaluator: what is in the file, and,
// where Chromium is installed, how the page behaves.
#include "plugin/page/comparison_page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "colmap_io/files/read_file.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/base/error.h"
#include "plugin/page/base64.h"
#include "tests/plugin/small_workspace.h"

namespace octacut::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

bool HasTools() {
  return std::system("command -v node chromedriver chromium >/dev/null 2>&1") ==
         0;
}

// The content of the script element of that id.
std::string Embedded(const std::string& page, const std::string& id) {
  const std::string mark = "id=\"" + id + "\">";
  const size_t begin = page.find(mark);
  if (begin == std::string::npos) {
    return "";
  }
  const size_t end = page.find("</script>", begin);
  return page.substr(begin + mark.size(), end - begin - mark.size());
}

class ComparisonPageTest : public SmallWorkspaceTest {
 protected:
  void SetUp() override {
    if (!fs::exists(ThreeJsPath())) {
      GTEST_SKIP() << "libjs-three is not installed";
    }
  }
  std::string Truth() const {
    return (Workspace() / "gt" / "reference.ply").string();
  }
  fs::path Page() const { return folder_ / "page.html"; }
  fs::path Report() const { return folder_ / "report.json"; }

  ProgramResult Compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(),
                     {"mesh_comparer",
                      "--reference_path",
                      Truth(),
                      "--output_path",
                      Report().string(),
                      "--html_path",
                      Page().string()});
    return RunOctacut(arguments);
  }
  ProgramResult Evaluate(const std::string& meshes) const {
    return RunOctacut({"mesh_evaluator",
                       "--workspace_path",
                       Workspace().string(),
                       "--mesh_path",
                       meshes,
                       "--output_path",
                       Report().string(),
                       "--html_path",
                       Page().string()});
  }
  std::string Hull() const {
    std::string path = (folder_ / "hull.ply").string();
    const ProgramResult result = RunOctacut({"visual_hull_mesher",
                                             "--workspace_path",
                                             Workspace().string(),
                                             "--OctahedralMeshing.hull_level",
                                             "6",
                                             "--output_path",
                                             path});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return path;
  }
  void LookAt(const std::string& kind) const {
    if (!HasTools()) {
      GTEST_SKIP() << "node, chromium and chromedriver are not installed "
                      "(workflows/setup.sh --with_test_tools 1)";
    }
    const fs::path log = folder_ / "browser.log";
    const std::string command = fmt::format(
        "node '{}/tests/page/page_test.mjs' '{}' '{}' {} >'{}' 2>&1",
        OCTACUT_SOURCE_DIR,
        Page().string(),
        Report().string(),
        kind,
        log.string());
    const int status = std::system(command.c_str());
    EXPECT_EQ(status, 0) << ReadFile(log);
  }
};

TEST(Base64, TheExamplesOfTheRfc) {
  const auto encoded = [](const std::string& text) {
    return EncodeBase64(
        {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(CheckPagePath, SaysWhichPackageIsMissing) {
  const TemporaryFolder folder;
  const OptionManager options;
  FileRoles files(options);
  EXPECT_THAT(
      [&] {
        CheckPagePath(folder / "p.html", &files, folder / "three.min.js");
      },
      ThrowsMessage<InputError>(HasSubstr("libjs-three")));
  EXPECT_FALSE(fs::exists(folder / "p.html"));
  EXPECT_NO_THROW(CheckPagePath("", &files, folder / "three.min.js"));
}

TEST_F(ComparisonPageTest, ComparesWithATruth) {
  const std::string hull = Hull();
  const ProgramResult result =
      Compare({"--input_path", hull + "," + Truth(), "--num_samples", "20000"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string page = ReadFile(Page());
  EXPECT_LT(page.size(), 15'000'000u);
  // Nothing is fetched.
  EXPECT_THAT(page, Not(HasSubstr("src=\"")));
  EXPECT_THAT(page, Not(HasSubstr("<link rel=\"stylesheet")));
  const auto report = nlohmann::json::parse(ReadFile(Report()));
  EXPECT_EQ(nlohmann::json::parse(Embedded(page, "report"))["meshes"],
            report["meshes"]);
  const auto shown = nlohmann::json::parse(Embedded(page, "page"));
  EXPECT_EQ(shown["has_truth"], true);
  ASSERT_EQ(shown["meshes"].size(), 3u);
  EXPECT_EQ(shown["meshes"][2]["reference"], true);
  const auto& places = report["meshes"][0]["places"];
  ASSERT_GE(places.size(), 2u);
  // The worst place is the maximum of the distances, which include vertices.
  EXPECT_NEAR(
      std::abs(places[0]["distance"].get<double>()),
      report["meshes"][0]["comparison"]["to_reference"]["max"],
      0.3 * double(report["meshes"][0]["comparison"]["to_reference"]["max"]));
  LookAt("truth");
}

TEST_F(ComparisonPageTest, SpeaksOfDistancesWithoutATruth) {
  const ProgramResult result = Compare({"--input_path",
                                        Hull(),
                                        "--reference_is_truth",
                                        "0",
                                        "--num_samples",
                                        "20000"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto report = nlohmann::json::parse(ReadFile(Report()));
  EXPECT_FALSE(report["meshes"][0]["comparison"].contains("scores"));
  const auto shown = nlohmann::json::parse(Embedded(ReadFile(Page()), "page"));
  EXPECT_EQ(shown["has_truth"], false);
  LookAt("distances");
}

TEST_F(ComparisonPageTest, ShowsCloudsAndTheFiguresOfABenchmark) {
  const std::string hull = Hull();
  IndexedMesh cloud;
  cloud.positions = ReadMesh(hull).mesh.positions;
  const std::string points = (folder_ / "points.ply").string();
  WriteMesh(points, cloud);
  const ProgramResult result =
      Compare({"--input_path", hull + "," + points, "--protocol", "metro"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto shown = nlohmann::json::parse(Embedded(ReadFile(Page()), "page"));
  EXPECT_EQ(shown["meshes"][1]["triangles"], 0);
  EXPECT_EQ(shown["meshes"][1]["full_points"], cloud.positions.size());
  EXPECT_THAT(shown["procedure"][1].get<std::string>(),
              HasSubstr("Benchmark protocol metro: Cignoni"));
  LookAt("benchmark");
}

TEST_F(ComparisonPageTest, JudgesByPhotographsAlone) {
  const ProgramResult result = Evaluate(Truth() + "," + Hull());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto report = nlohmann::json::parse(ReadFile(Report()));
  EXPECT_EQ(report["ranking"]["order"][0], "reference.ply");
  EXPECT_FALSE(report["meshes"][1]["comparison"].contains("scores"));
  const auto shown = nlohmann::json::parse(Embedded(ReadFile(Page()), "page"));
  EXPECT_EQ(shown["has_truth"], false);
  EXPECT_EQ(shown["photographs"].size(), size_t(kSmallViews));
  LookAt("photographs");
}

TEST_F(ComparisonPageTest, MistakesAreNamed) {
  EXPECT_THAT(RunOctacut({"mesh_comparer",
                          "--input_path",
                          Truth(),
                          "--reference_path",
                          Truth(),
                          "--html_path",
                          (folder_ / "gone" / "page.html").string()})
                  .err,
              HasSubstr("gone"));
  EXPECT_THAT(RunOctacut({"mesh_comparer",
                          "--input_path",
                          Truth(),
                          "--reference_path",
                          Truth(),
                          "--html_path",
                          Truth()})
                  .err,
              HasSubstr("html_path = "));
}

}  // namespace
}  // namespace octacut::testing
