// The shell workflows that follow COLMAP's mapper, on a small example.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "colmap_io/files/read_file.h"
#include "plugin/page/comparison_page.h"
#include "plugin/report.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Runs a script of workflows/ from another folder than the tree's. Programs in
// `bin` come first.
ProgramResult RunWorkflow(const std::string& script,
                          const std::string& arguments,
                          const fs::path& bin = "/usr/bin") {
  const TemporaryFolder folder;
  const fs::path out = folder / "out";
  const fs::path err = folder / "err";
  const std::string command = fmt::format(
      "cd / && PATH='{}':$PATH OCTACUT='{}' '{}/workflows/{}' {} "
      ">'{}' 2>'{}'",
      bin.string(),
      ExecutablePath(),
      OCTACUT_SOURCE_DIR,
      script,
      arguments,
      out.string(),
      err.string());
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), ReadFile(out), ReadFile(err)};
}

std::string Quoted(const fs::path& path) {
  return fmt::format("'{}'", path.string());
}

TEST(Workflows, CompareDenseSaysWhatIsMissing) {
  const TemporaryFolder folder;
  const std::string workspace = Quoted(folder.Path());
  EXPECT_EQ(RunWorkflow("compare_dense.sh", "").exit_code, 1);
  EXPECT_EQ(RunWorkflow("compare_dense.sh", "--help").exit_code, 0);
  EXPECT_THAT(RunWorkflow("compare_dense.sh", "/gone").err,
              HasSubstr("/gone: no such folder"));
  const ProgramResult no_mesh = RunWorkflow("compare_dense.sh", workspace);
  EXPECT_EQ(no_mesh.exit_code, 1);
  EXPECT_THAT(no_mesh.err, HasSubstr("meshed-octahedral.ply: no such mesh"));
  folder.Write("meshed-octahedral.ply", "ply\n");
  const ProgramResult alone = RunWorkflow("compare_dense.sh", workspace);
  EXPECT_EQ(alone.exit_code, 0);
  EXPECT_THAT(alone.out, HasSubstr("no mesh of COLMAP"));
  EXPECT_THAT(alone.out, HasSubstr("no page, because there is no folder"));
}

TEST(Workflows, AfterMapperMeshesAndComparesAndCanBeRepeated) {
  const TemporaryFolder folder;
  const fs::path workspace = folder / "with blanks";
  const ProgramResult example = RunOctacut({"example_creator",
                                            "--output_path",
                                            workspace.string(),
                                            "--scene",
                                            "sphere",
                                            "--num_views",
                                            "12",
                                            "--width",
                                            "160",
                                            "--height",
                                            "120",
                                            "--reference_resolution",
                                            "40"});
  ASSERT_EQ(example.exit_code, 0) << example.err;
  fs::create_directories(workspace / "dense" / "0");
  const fs::path reference = workspace / "gt" / "reference.ply";
  fs::copy(reference, workspace / "dense" / "0" / "meshed-poisson.ply");
  for (int run = 0; run < 2; ++run) {
    const ProgramResult result =
        RunWorkflow("after_mapper.sh",
                    Quoted(workspace) +
                        " --OctahedralMeshing.hull_level 5"
                        " --OctahedralMeshing.target_level 6"
                        " --picture 0");
    ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("meshed-octahedral.ply (reference)"));
    EXPECT_THAT(result.out, HasSubstr("meshed-poisson.ply "));
    EXPECT_THAT(result.out, HasSubstr("not which one is right"));
    EXPECT_TRUE(fs::is_regular_file(workspace / "meshed-octahedral.ply"));
    EXPECT_NO_THROW(Json::parse(ReadFile(workspace / "compare-dense.json")));
    if (fs::exists(ThreeJsPath())) {
      EXPECT_THAT(ReadFile(workspace / "compare-dense.html"),
                  HasSubstr("meshed-poisson.ply"));
    }
  }

  // Wherever COLMAP leaves its meshes, and two of the same name.
  fs::create_directories(workspace / "dense" / "1");
  fs::copy(reference, workspace / "meshed-delaunay.ply");
  fs::copy(reference, workspace / "dense" / "meshed-advancing-front.ply");
  fs::copy(reference, workspace / "dense" / "1" / "meshed-poisson.ply");
  const ProgramResult result = RunWorkflow(
      "compare_dense.sh", Quoted(workspace) + " --num_samples 10000");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const char* name : {"meshed-delaunay.ply",
                           "meshed-advancing-front.ply",
                           "dense/0/meshed-poisson.ply",
                           "dense/1/meshed-poisson.ply"}) {
    EXPECT_THAT(result.out, HasSubstr(name));
  }
}

// Without COLMAP's work: mistakes that are found before.
TEST(Workflows, ImagesToMeshNamesMistakes) {
  const TemporaryFolder folder;
  const std::string workspace = Quoted(folder / "w");
  EXPECT_EQ(RunWorkflow("images_to_mesh.sh", "").exit_code, 1);
  EXPECT_EQ(RunWorkflow("images_to_mesh.sh", "--help").exit_code, 0);
  EXPECT_THAT(RunWorkflow("images_to_mesh.sh", "/gone " + workspace).err,
              HasSubstr("/gone: there is no such folder of photographs"));
  const std::string both = Quoted(folder.Path()) + " " + workspace;
  for (const auto& [options, message] :
       {std::pair("--turntable yes", "--turntable yes: must be 0 or 1"),
        std::pair("--background_path /b", "is for --turntable 1"),
        std::pair("--max_num_features many", "must be a positive number")}) {
    const ProgramResult result =
        RunWorkflow("images_to_mesh.sh", both + " " + options);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_FALSE(fs::exists(folder / "w"));
  }
}

TEST(Workflows, ImagesToMeshKeepsWorkOfOthers) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "w" / "images");
  const std::string database = folder.Write("w/database.db", "precious");
  const ProgramResult result =
      RunWorkflow("images_to_mesh.sh",
                  Quoted(folder / "w/images") + " " + Quoted(folder / "w"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err,
              HasSubstr("w/database.db: was not made by this script"));
  EXPECT_EQ(ReadFile(database), "precious");
}

// A stand-in for COLMAP: its feature extractor and matcher note that they ran,
// its mapper copies the example's model.
TEST(Workflows, ImagesToMeshSkipsWhatIsFinished) {
  const TemporaryFolder folder;
  const fs::path example = folder / "example";
  const ProgramResult made = RunOctacut({"example_creator",
                                         "--output_path",
                                         example.string(),
                                         "--scene",
                                         "lump",
                                         "--num_views",
                                         "12",
                                         "--width",
                                         "160",
                                         "--height",
                                         "120",
                                         "--reference_resolution",
                                         "40"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  fs::create_directories(folder / "bin");
  const fs::path colmap = folder / "bin" / "colmap";
  std::ofstream(colmap) << fmt::format(
      R"(#!/usr/bin/env bash
while (($#)); do
  case $1 in
    feature_extractor | exhaustive_matcher | mapper) step=$1 ;;
    -h) exit 0 ;;
    --database_path) database=$2 ;;
    --output_path) output=$2 ;;
  esac
  shift
done
echo "$step" >>'{0}/ran'
touch "$database"
[[ $step != mapper ]] || cp -r '{1}/sparse/0' "$output/0"
)",
      folder.Path().string(),
      example.string());
  fs::permissions(colmap, fs::perms::owner_all);
  const auto run = [&](const std::string& options) {
    std::ofstream(folder / "ran").close();
    const ProgramResult result = RunWorkflow(
        "images_to_mesh.sh",
        fmt::format("'{}/images' '{}' --OctahedralMeshing.hull_level 5 "
                    "--OctahedralMeshing.target_level 6 --picture 0 {}",
                    example.string(),
                    (folder / "w").string(),
                    options),
        folder / "bin");
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    return ReadFile(folder / "ran");
  };
  EXPECT_EQ(run(""), "feature_extractor\nexhaustive_matcher\nmapper\n");
  // Later commands find the photographs without --image_path.
  EXPECT_TRUE(fs::equivalent(folder / "w" / "images", example / "images"));
  const fs::path mesh = folder / "w" / "meshed-octahedral.ply";
  const std::string bytes = ReadFile(mesh);
  const auto masks_time = fs::last_write_time(folder / "w/masks/masks.json");
  fs::remove(folder / "w" / "steps" / "mesh");
  EXPECT_EQ(run(""), "");
  EXPECT_EQ(ReadFile(mesh), bytes);
  // An option of the mesher redoes the mesh alone, one of COLMAP all after it.
  run("--OctahedralMeshing.ballooning 0.1");
  EXPECT_NE(ReadFile(mesh), bytes);
  EXPECT_EQ(fs::last_write_time(folder / "w/masks/masks.json"), masks_time);
  EXPECT_EQ(run("--max_num_features 1000"),
            "feature_extractor\nexhaustive_matcher\nmapper\n");
  EXPECT_NE(fs::last_write_time(folder / "w/masks/masks.json"), masks_time);
  EXPECT_EQ(ReadFile(mesh), bytes);
}

TEST(Workflows, OptionValues) {
  const auto value = [](const std::string& arguments) {
    return RunWorkflow("option_value.sh", "--name 'by default' " + arguments)
        .out;
  };
  EXPECT_EQ(value(""), "by default\n");
  EXPECT_EQ(value("--other x --names y"), "by default\n");
  EXPECT_EQ(value("--other --name 'a b' z"), "a b\n");
  EXPECT_EQ(value("--name='a b' z"), "a b\n");
  EXPECT_EQ(value("--name"), "by default\n");
}

TEST(Workflows, AfterMapperFailsWithTheMesher) {
  const TemporaryFolder folder;
  const ProgramResult result =
      RunWorkflow("after_mapper.sh", Quoted(folder.Path()));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("ERROR: "));
}

TEST(Workflows, BenchmarkAccuracyPicksScenesAndSets) {
  const auto list = [](const std::string& options) {
    return RunWorkflow("benchmark_accuracy.sh", "--list 1 " + options);
  };
  const ProgramResult all = list("");
  ASSERT_EQ(all.exit_code, 0) << all.err;
  EXPECT_THAT(all.out, HasSubstr("scenes: cup-2 clean default at level 8"));
  EXPECT_THAT(all.out, HasSubstr("scenes: temple clean default at level 9"));
  EXPECT_EQ(list("--only hard --scenes drapery-4").out,
            "hard: drapery-4 clean hull-default at level 8\n"
            "hard: drapery-4 clean no-refinement at level 8\n"
            "hard: drapery-4 clean default at level 8\n");
  EXPECT_EQ(list("--only hard --scenes homer-exact --sets default").out,
            "hard: homer-exact clean default at level 9\n");
  EXPECT_EQ(list("--only degraded --scenes lump --sets eroded-2,noise").out,
            "degraded: lump noise-5 default at level 8\n"
            "degraded: lump eroded-2 default at level 8\n");
  EXPECT_EQ(
      list("--only ablations --scenes rocker --sets hull --data_level 7").out,
      "ablations: rocker-exact clean hull at level 7\n");
  EXPECT_EQ(list("--only ablations --scenes cup --sets hull,all-handles").out,
            "ablations: cup-1 clean hull at level 8\n"
            "ablations: cup-1 clean all-handles at level 8\n"
            "ablations: cup-2 clean all-handles at level 8\n");
  for (const auto& [options, message] :
       {std::pair("--scenes teapot", "scenes = teapot: there are example"),
        std::pair("--sets best", "sets = best: there are default"),
        std::pair("--only all", "only = all: there are scenes"),
        std::pair("--level 99", "level = 99: must be"),
        std::pair("--levle 9", "--levle: no such option")}) {
    const ProgramResult result = list(options);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(message));
  }
}

// A line of what benchmark_accuracy.sh records, with the mean error `mean` (of
// the diagonal), aligned as well.
std::string AccuracyRecord(const std::string& degradation,
                           double mean,
                           int crossing,
                           const std::string& set = "default",
                           const std::string& part = "scenes") {
  const nlohmann::json distances = {{"mean_over_diagonal", mean},
                                    {"percentile_90_over_diagonal", mean},
                                    {"max_over_diagonal", mean}};
  const nlohmann::json score = {{"f_score", 0.9}, {"recall", 0.9}};
  nlohmann::json comparison = {{"to_reference", distances},
                               {"from_reference", distances},
                               {"judged_share", 0.75},
                               {"scores", {score, score, score}}};
  nlohmann::json aligned = comparison;
  aligned["to_reference"]["mean_over_diagonal"] = mean / 2;
  aligned["from_reference"]["mean_over_diagonal"] = mean / 2;
  return nlohmann::json{{"part", part},
                        {"scene", "lump"},
                        {"degradation", degradation},
                        {"set", set},
                        {"level", 7},
                        {"state", "done"},
                        {"seconds", 30},
                        {"refine_seconds", 18},
                        {"late_seconds", 2},
                        {"version", "1"},
                        {"audit", {{"genus", 0}, {"components", 1}}},
                        {"truth", {{"genus", 1}, {"components", 1}}},
                        {"comparison", comparison},
                        {"aligned", aligned},
                        {"evaluation",
                         {{"self_intersections", {{"triangles", crossing}}},
                          {"silhouettes", nlohmann::json::object()},
                          {"reprojection", nlohmann::json::object()}}}}
      .dump();
}

TEST(Workflows, AccuracyTablesMarkWhatMissesTheAims) {
  if (std::system("command -v jq >/dev/null") != 0) {
    GTEST_SKIP() << "jq is not installed";
  }
  const TemporaryFolder folder;
  folder.Write("records",
               AccuracyRecord("clean", 2e-4, 0) +
                   AccuracyRecord("eroded-2", 3.2e-4, 0) +
                   AccuracyRecord("dilated-2", 2.2e-4, 3) +
                   AccuracyRecord("poses-0.5", 1.4e-4, 0) +
                   AccuracyRecord("clean", 2.4e-4, 0, "ncc") +
                   AccuracyRecord("clean", 9e-4, 0, "hull-default", "hard") +
                   AccuracyRecord("clean", 3e-4, 7, "default", "hard"));
  folder.Write("hard", "lump --scene lump\n");
  folder.Write("scenes", "lump --scene lump\n");
  folder.Write("degradations", "eroded-2 -2\ndilated-2 2\nposes-0.5 1\n");
  folder.Write("sets", "default\nncc --consistency ncc\nhull\n");
  const std::string at = folder.Path().string();
  const int status = std::system(
      fmt::format("jq -L '{0}' -rs --arg machine M --arg command C --argjson "
                  "level 7 --argjson data_level 8 --argjson threads 2 "
                  "--rawfile own_scenes '{1}/scenes' --rawfile hard_scenes "
                  "'{1}/hard' --rawfile degradations "
                  "'{1}/degradations' --rawfile option_sets '{1}/sets' "
                  "-f '{0}/accuracy_tables.jq' '{1}/records' >'{1}/tables'",
                  OCTACUT_SOURCE_DIR "/workflows",
                  at)
          .c_str());
  ASSERT_EQ(status, 0);
  const std::string tables = ReadFile(folder / "tables");
  EXPECT_THAT(
      tables,
      HasSubstr("| no self-intersecting triangle | 4 of 5 | lump dilated-2 |"));
  EXPECT_THAT(tables,
              HasSubstr("| genus and components of the truth (clean scenes) | "
                        "0 of 1 | lump |"));
  EXPECT_THAT(tables,
              HasSubstr("error at most 1.5 x | 2 of 3 | lump eroded-2 |"));
  // Hard scenes stand apart.
  EXPECT_THAT(
      tables,
      HasSubstr("| lump | hull | 75.0 | 0.090 | 0.090 | 90.0 | **0** (1)"
                " | 1 |"));
  EXPECT_THAT(tables, HasSubstr("| lump | default | 75.0 | 0.030 | 0.030 |"));
  // Worse poses are held against the aligned clean mesh.
  EXPECT_THAT(tables, HasSubstr("| lump | **1.60** | 1.10 | 1.40 |"));
  EXPECT_THAT(tables, HasSubstr("| **0** (1) | 1 | 0 | 30.0 | – | 1.80 |"));
  EXPECT_THAT(tables, HasSubstr("| **0** (1) | 1 | **3** |"));
  EXPECT_THAT(tables,
              HasSubstr("| set | lump |\n| --- | ---: |\n| ncc | **1.20** |"));
}

TEST(Workflows, PassShellcheck) {
  if (std::system("command -v shellcheck >/dev/null") != 0) {
    GTEST_SKIP() << "shellcheck is not installed";
  }
  EXPECT_EQ(std::system("cd '" OCTACUT_SOURCE_DIR
                        "' && shellcheck workflows/*.sh .ci/run"),
            0);
}

}  // namespace
}  // namespace octacut
