// mesh_comparer --protocol as a user meets it; what the protocols measure is
// tested in tests/core/benchmark/protocols.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "colmap_io/files/read_file.h"
#include "tests/colmap_io/benchmark/mat_writer.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string UnitSquare(double height) {
  const std::string z = std::to_string(height);
  return "OFF\n4 1 0\n0 0 " + z + "\n1 0 " + z + "\n1 1 " + z + "\n0 1 " + z +
         "\n4 0 1 2 3\n";
}

std::string LatticeCloud(int size, double step, double height) {
  std::string text;
  for (int i = 0; i <= size; ++i) {
    for (int j = 0; j <= size; ++j) {
      text += "v " + std::to_string(step * i) + " " + std::to_string(step * j) +
              " " + std::to_string(height) + "\n";
    }
  }
  return text;
}

const char kVolume[] =
    R"({"orthogonal_axis": "Z", "axis_min": -1, "axis_max": 1,
  "bounding_polygon": [[-1, -1, 0], [2, -1, 0], [2, 2, 0], [-1, 2, 0]]})";

class BenchmarkProtocolTest : public ::testing::Test {
 protected:
  ProgramResult Compare(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {
        "mesh_comparer", "--output_path", folder_ / "out.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunOctacut(arguments);
  }
  nlohmann::json Report() const {
    return nlohmann::json::parse(ReadFile(folder_ / "out.json"));
  }
  // A figure of the only mesh.
  double Figure(const std::string& name) const {
    const nlohmann::json report = Report();
    for (const auto& figure : report["meshes"][0]["protocol"]["figures"]) {
      if (figure["name"] == name) {
        return figure["value"];
      }
    }
    ADD_FAILURE() << name;
    return 0;
  }
  std::string DtuMask() const {
    std::string path = folder_ / "ObsMask1_10.mat";
    MatWriter writer(path);
    writer.Logicals("ObsMask", {8, 8, 8}, std::vector<uint8_t>(512, 1));
    writer.Doubles("BB", {2, 3}, {-20, 60, -20, 60, -20, 60});
    writer.Doubles("Res", {1, 1}, {10});
    return path;
  }
  std::string DtuPlane() const {
    std::string path = folder_ / "Plane1.mat";
    MatWriter(path).Doubles("P", {4, 1}, {0, 0, 1, 5});
    return path;
  }

  TemporaryFolder folder_;
  const std::string square_ = folder_.Write("square.off", UnitSquare(0));
  const std::string above_ = folder_.Write("above.off", UnitSquare(0.25));
};

TEST_F(BenchmarkProtocolTest, MetroIsNamedInTableAndReport) {
  const ProgramResult result = Compare({"--input_path",
                                        above_,
                                        "--reference_path",
                                        square_,
                                        "--protocol",
                                        "metro"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("protocol metro"),
                    HasSubstr("Hausdorff"),
                    Not(HasSubstr("precision"))));
  EXPECT_EQ(Report()["protocol"]["name"], "metro");
  EXPECT_THAT(Report()["protocol"]["rules"].get<std::string>(),
              HasSubstr("Cignoni"));
  EXPECT_NEAR(Figure("forward mean"), 0.25, 1e-9);
  EXPECT_NEAR(Figure("Hausdorff"), 0.25, 1e-9);
  EXPECT_FALSE(Report()["meshes"][0]["comparison"].contains("scores"));
}

TEST_F(BenchmarkProtocolTest, MiddleburyNeedsFilledHoles) {
  const std::vector<std::string> arguments = {"--input_path",
                                              above_,
                                              "--reference_path",
                                              square_,
                                              "--protocol",
                                              "middlebury",
                                              "--tolerances",
                                              "0.3"};
  EXPECT_THAT(Compare(arguments).err, HasSubstr("--crop_path"));
  std::vector<std::string> with_filler = arguments;
  with_filler.insert(
      with_filler.end(),
      {"--crop_path", folder_.Write("filler.off", UnitSquare(-1))});
  const ProgramResult result = Compare(with_filler);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NEAR(Figure("accuracy"), 0.25, 1e-9);
  EXPECT_EQ(Figure("completeness"), 1);
}

TEST_F(BenchmarkProtocolTest, TanksAndTemplesMovesTheMesh) {
  const std::string cloud =
      folder_.Write("cloud.obj", LatticeCloud(50, 0.02, 0));
  const std::string lifted =
      folder_.Write("lifted.obj", LatticeCloud(50, 0.02, 0.01));
  const ProgramResult result = Compare({"--input_path",
                                        lifted,
                                        "--reference_path",
                                        cloud,
                                        "--protocol",
                                        "tanks_and_temples",
                                        "--tolerances",
                                        "0.005",
                                        "--crop_path",
                                        folder_.Write("crop.json", kVolume),
                                        "--transform_output_path",
                                        folder_ / "matrix.txt"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("at 0.005: precision, %"));
  const nlohmann::json mesh = Report()["meshes"][0];
  EXPECT_EQ(mesh["protocol"]["scores"][0]["f_score"], 1);
  EXPECT_NEAR(mesh["protocol"]["matrix"][2][3].get<double>(), -0.01, 1e-6);
  EXPECT_LT(mesh["comparison"]["to_reference"]["max"], 1e-6);
  EXPECT_THAT(ReadFile(folder_ / "matrix.txt"), HasSubstr("-0.0"));
}

TEST_F(BenchmarkProtocolTest, Eth3dReadsTheProjectOfScans) {
  folder_.Write("scan.obj", "v 0.3 0.2 2\nv -0.3 0.2 2\n");
  const std::string project = folder_.Write(
      "scans.mlp",
      "<MeshLabProject><MeshGroup><MLMesh filename=\"scan.obj\"><MLMatrix44>"
      "1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</MLMatrix44></MLMesh></MeshGroup>"
      "</MeshLabProject>");
  // One point at the first hit, one before the second.
  const std::string cloud =
      folder_.Write("points.obj", "v 5.3 0.2 2\nv 4.85 0.1 1\n");
  const ProgramResult result = Compare({"--input_path",
                                        cloud,
                                        "--reference_path",
                                        project,
                                        "--protocol",
                                        "eth3d",
                                        "--tolerances",
                                        "0.5,0.01"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("at 0.01: accuracy, %"));
  const nlohmann::json scores = Report()["meshes"][0]["protocol"]["scores"];
  ASSERT_EQ(scores.size(), 2u);
  EXPECT_EQ(scores[0]["precision"], 0.5);
  EXPECT_EQ(scores[0]["recall"], 0.5);
}

TEST_F(BenchmarkProtocolTest, DtuReadsItsMasks) {
  const std::string truth = folder_.Write("truth.obj", LatticeCloud(40, 1, 0));
  const std::string cloud =
      folder_.Write("cloud.obj", LatticeCloud(40, 1, 0.5));
  const ProgramResult result = Compare({"--input_path",
                                        cloud,
                                        "--reference_path",
                                        truth,
                                        "--protocol",
                                        "dtu",
                                        "--crop_path",
                                        DtuMask() + "," + DtuPlane()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NEAR(Figure("overall"), 0.5, 1e-9);
  EXPECT_EQ(Figure("points"), 41 * 41);
}

TEST_F(BenchmarkProtocolTest, WhatIsMissingOrExcludedIsNamed) {
  struct Case {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::string volume = folder_.Write("crop.json", kVolume);
  const std::vector<Case> cases = {
      {{"--protocol", "tanks_and_temples", "--crop_path", volume},
       "--tolerances: the protocol tanks_and_temples needs one value, and none "
       "is given: tau"},
      {{"--protocol", "tanks_and_temples", "--tolerances", "1"},
       "--crop_path: the protocol tanks_and_temples needs one value, and none "
       "is given: the scene's"},
      {{"--protocol", "tanks_and_temples", "--tolerances", "1,2"},
       "--tolerances = 1,2: the protocol tanks_and_temples takes at most 1"},
      {{"--protocol", "middlebury"}, "--tolerances: the protocol middlebury"},
      {{"--protocol", "eth3d", "--tolerances", "0.1"},
       "the protocol eth3d needs the MeshLab project"},
      {{"--protocol", "eth3d", "--tolerances", "-0.1"},
       "--tolerances = -0.1: must be positive"},
      {{"--protocol", "dtu"}, "--crop_path: the protocol dtu needs two"},
      {{"--protocol", "dtu", "--crop_path", DtuMask() + "," + DtuMask()},
       "may be given once"},
      {{"--protocol", "metro", "--tolerances", "1"},
       "--tolerances = 1: is not used by the protocol metro"},
      {{"--tolerances", "1"}, "is not used by the protocol none"},
      {{"--protocol", "metro", "--align", "1"}, "--transform_path"},
      {{"--protocol", "metro", "--bounding_box", "0,0,0,1,1,1"},
       "--bounding_box cannot be used with --protocol metro"},
      {{"--protocol", "other"}, "must be one of none, metro, middlebury"},
  };
  for (const Case& mistake : cases) {
    std::vector<std::string> arguments = {
        "--input_path", above_, "--reference_path", square_};
    arguments.insert(
        arguments.end(), mistake.arguments.begin(), mistake.arguments.end());
    const ProgramResult result = Compare(arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(mistake.message));
    EXPECT_THAT(result.out, IsEmpty());
  }
}

}  // namespace
}  // namespace octacut
