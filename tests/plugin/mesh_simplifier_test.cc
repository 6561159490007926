// mesh_simplifier as a user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "colmap_io/files/read_file.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/mesh/audit.h"
#include "tests/core/print/print_shapes.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class MeshSimplifierTest : public ::testing::Test {
 protected:
  MeshSimplifierTest() {
    IndexedMesh mesh = Potato(24);  // 6912 triangles
    for (const Eigen::Vector3d& p : mesh.positions) {
      mesh.colors.push_back({uint8_t(128 + 50 * p.x()), 0, 200});
    }
    WriteMesh(folder_ / "full.ply", mesh);
  }

  // Simplifies full.ply, or what the arguments name first.
  ProgramResult Simplify(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = {"mesh_simplifier"};
    if (arguments[0] != "--input_path") {
      all.insert(all.end(), {"--input_path", Path("full.ply")});
    }
    all.insert(all.end(), arguments.begin(), arguments.end());
    return RunOctacut(all);
  }
  std::string Path(const std::string& name) const {
    return (folder_ / name).string();
  }
  nlohmann::json Report(const std::string& name) const {
    return nlohmann::json::parse(ReadFile(folder_ / name));
  }

  TemporaryFolder folder_;
};

TEST_F(MeshSimplifierTest, WritesTheMeshAndHowFarItIs) {
  const ProgramResult result =
      Simplify({"--output_path", Path("s.ply"), "--target_faces", "700"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("s.ply"));
  EXPECT_THAT(result.out, HasSubstr("Hausdorff"));
  const IndexedMesh mesh = ReadMesh(folder_ / "s.ply").mesh;
  EXPECT_EQ(mesh.triangles.size(), 700u);
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.colors.size(), mesh.positions.size());
  EXPECT_EQ(AuditMesh(mesh, Context(1)).DescribeFailure(), "");
  const nlohmann::json report = Report("s.ply.json");
  EXPECT_EQ(report["input"]["triangles"], 6912);
  ASSERT_EQ(report["levels"].size(), 1u);
  const nlohmann::json& level = report["levels"][0];
  EXPECT_EQ(level["audit"]["triangles"], 700);
  EXPECT_EQ(level["audit"]["failure"], "");
  EXPECT_EQ(level["self_intersections"], 0);
  const double mean =
      level["comparison"]["from_reference"]["mean_over_diagonal"];
  EXPECT_GT(mean, 0);
  EXPECT_LT(mean, 0.002);
  EXPECT_LT(mean, level["comparison"]["hausdorff_over_diagonal"]);
}

TEST_F(MeshSimplifierTest, AChainGetsCoarserByTheSameFactor) {
  const ProgramResult result = Simplify({"--output_path",
                                         Path("chain.obj"),
                                         "--target_ratio",
                                         "0.0625",
                                         "--levels",
                                         "4"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  size_t expected = 6912;
  for (const char* name :
       {"chain-1.obj", "chain-2.obj", "chain-3.obj", "chain-4.obj"}) {
    expected /= 2;
    EXPECT_EQ(ReadMesh(folder_ / name).mesh.triangles.size(),
              expected - expected % 2);
  }
  EXPECT_FALSE(fs::exists(folder_ / "chain.obj"));
  EXPECT_EQ(Report("chain.obj.json")["levels"].size(), 4u);
}

TEST_F(MeshSimplifierTest, KeepsTheGreatestDistance) {
  const ProgramResult result = Simplify(
      {"--output_path", Path("e.ply"), "--max_error", "0.02", "--levels", "2"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json report = Report("e.ply.json");
  EXPECT_LE(report["levels"][0]["comparison"]["hausdorff"], 0.01);
  EXPECT_LE(report["levels"][1]["comparison"]["hausdorff"], 0.02);
  EXPECT_LT(report["levels"][1]["audit"]["triangles"],
            report["levels"][0]["audit"]["triangles"]);
  EXPECT_LT(report["levels"][0]["audit"]["triangles"], 6000);
}

TEST_F(MeshSimplifierTest, SameBytesForAnyNumberOfThreads) {
  for (const char* threads : {"1", "3"}) {
    const std::string name = std::string(threads) + ".ply";
    const ProgramResult result = Simplify({"--output_path",
                                           Path(name),
                                           "--target_faces",
                                           "500",
                                           "--num_threads",
                                           threads});
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  EXPECT_EQ(ReadFile(folder_ / "1.ply"), ReadFile(folder_ / "3.ply"));
}

TEST_F(MeshSimplifierTest, WarnsWhatWasReached) {
  // A closed surface with a handle has at least 14 triangles.
  WriteMesh(folder_ / "torus.ply", Torus(24, 1, 0.4));
  const ProgramResult result = Simplify({"--input_path",
                                         Path("torus.ply"),
                                         "--output_path",
                                         Path("s.ply"),
                                         "--target_faces",
                                         "4"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const size_t reached = ReadMesh(folder_ / "s.ply").mesh.triangles.size();
  ASSERT_GE(reached, 14u);
  EXPECT_THAT(result.err,
              HasSubstr("4 triangles could not be reached, " +
                        std::to_string(reached) + " are left"));
}

TEST_F(MeshSimplifierTest, AnErrorThatPermitsNothingKeepsTheMesh) {
  const ProgramResult result =
      Simplify({"--output_path", Path("s.ply"), "--max_error", "1e-9"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, Not(HasSubstr("nan")));
  const nlohmann::json comparison =
      Report("s.ply.json")["levels"][0]["comparison"];
  EXPECT_GT(comparison["reference_diagonal"].get<double>(), 1);
}

TEST_F(MeshSimplifierTest, MistakesAreNamed) {
  const std::string open =
      folder_.Write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder_.Write("s.ply", "precious");
  const std::string out = Path("s.ply");
  struct Case {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::vector<Case> cases = {
      {{"--output_path", out}, "give exactly one of --target_faces"},
      {{"--output_path", out, "--target_faces", "9", "--max_error", "1"},
       "give exactly one of --target_faces"},
      {{"--output_path", out, "--target_faces", "3"}, "--target_faces = 3: "},
      {{"--output_path", out, "--target_faces", "10000000"}, " has only "},
      {{"--output_path", out, "--target_ratio", "1"}, "--target_ratio = 1: "},
      {{"--output_path", out, "--max_error", "-1"}, "--max_error = -1: "},
      {{"--output_path", out, "--target_faces", "9", "--levels", "0"},
       "--levels = 0: "},
      {{"--output_path", Path("s.xyz"), "--target_faces", "9"},
       "unknown mesh extension"},
      {{"--input_path", open, "--output_path", out, "--target_faces", "9"},
       "open.off: 3 boundary edges"},
      {{"--output_path",
        out,
        "--target_faces",
        "9",
        "--report_path",
        Path("full.ply")},
       "--report_path = "},
      {{"--output_path", Path("full.ply"), "--target_faces", "9"},
       "full.ply: must not be the same file as the mesh to simplify"},
  };
  for (const Case& mistake : cases) {
    const ProgramResult result = Simplify(mistake.arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(mistake.message));
    EXPECT_THAT(result.out, IsEmpty());
  }
  EXPECT_EQ(ReadFile(folder_ / "s.ply"), "precious");
}

}  // namespace
}  // namespace octacut
