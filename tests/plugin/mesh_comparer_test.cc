// mesh_comparer as a user meets it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "colmap_io/files/read_file.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// The unit square at a height, as text OFF of one quadrilateral.
std::string Square(double height, double width = 1) {
  const std::string z = std::to_string(height);
  const std::string x = std::to_string(width);
  return "OFF\n4 1 0\n0 0 " + z + "\n" + x + " 0 " + z + "\n" + x + " 1 " + z +
         "\n0 1 " + z + "\n4 0 1 2 3\n";
}

// That of kTetrahedron, twice as large and moved by (3, 0, 0).
const char kMovedTetrahedron[] =
    "v 3 0 0\nv 5 0 0\nv 3 2 0\nv 3 0 2\n"
    "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

const char kTetrahedron[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nelement face 4\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

class MeshComparerTest : public ::testing::Test {
 protected:
  // Runs with the options and few samples.
  ProgramResult Compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "mesh_comparer");
    arguments.insert(arguments.end(), {"--num_samples", "2000"});
    return RunOctacut(arguments);
  }

  nlohmann::json Report() const {
    return nlohmann::json::parse(ReadFile(folder_ / "out.json"));
  }

  TemporaryFolder folder_;
};

TEST_F(MeshComparerTest, TablesAndReport) {
  const std::string reference = folder_.Write("ref.off", Square(0));
  const std::string half = folder_.Write("half.off", Square(0, 0.5));
  const std::string above = folder_.Write("above.off", Square(0.01));
  const ProgramResult result = Compare({"--input_path",
                                        half,
                                        "--input_path",
                                        above,
                                        "--reference_path",
                                        reference,
                                        "--thresholds",
                                        "0.0001,0.01",
                                        "--output_path",
                                        folder_ / "out.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* text : {"half.off",
                           "above.off",
                           "ref.off (reference)",
                           "no (4)",
                           "at 0.01 %: precision",
                           "accuracy of 90 %"}) {
    EXPECT_THAT(result.out, HasSubstr(text));
  }
  EXPECT_THAT(result.out, Not(HasSubstr(half)));

  const nlohmann::json report = Report();
  EXPECT_EQ(report["command"], "mesh_comparer");
  EXPECT_EQ(report["reference"]["path"], reference);
  EXPECT_EQ(report["reference"]["audit"]["boundary_edges"], 4);
  ASSERT_EQ(report["meshes"].size(), 2u);
  const nlohmann::json& first = report["meshes"][0]["comparison"];
  EXPECT_NEAR(first["reference_diagonal"].get<double>(), 1.41421356, 1e-6);
  EXPECT_EQ(first["to_reference"]["samples"], 2000);
  EXPECT_NEAR(first["to_reference"]["mean"].get<double>(), 0, 1e-9);
  EXPECT_NEAR(first["from_reference"]["max"].get<double>(), 0.5, 1e-6);
  EXPECT_NEAR(first["from_reference"]["mean"].get<double>(), 0.125, 1e-3);
  EXPECT_EQ(first["scores"][0]["precision"], 1);
  EXPECT_NEAR(first["scores"][0]["recall"].get<double>(), 0.5, 2e-3);
  EXPECT_EQ(report["meshes"][0]["audit"]["closed"], false);
  EXPECT_EQ(report["meshes"][0]["self_intersections"]["pairs"], 0);
  EXPECT_THAT(report["meshes"][0]["notes"][0].get<std::string>(),
              HasSubstr("more than three corners"));
  const nlohmann::json& second = report["meshes"][1]["comparison"];
  EXPECT_NEAR(second["to_reference"]["rms"].get<double>(), 0.01, 1e-6);
  EXPECT_NEAR(second["to_reference"]["rms_over_diagonal"].get<double>(),
              0.01 / 1.41421356,
              1e-6);
  EXPECT_NEAR(second["accuracy"].get<double>(), 0.01, 1e-6);
  EXPECT_EQ(second["completeness"], 0);
  EXPECT_EQ(second["scores"][1]["f_score"], 1);
}

TEST_F(MeshComparerTest, OnlyWhatIsInTheBoxIsJudged) {
  const std::string reference = folder_.Write("ref.off", Square(0));
  const std::string half = folder_.Write("half.off", Square(0, 0.5));
  std::vector<std::string> arguments = {"--input_path",
                                        half,
                                        "--reference_path",
                                        reference,
                                        "--output_path",
                                        folder_ / "out.json",
                                        "--bounding_box",
                                        "-1,-1,-1,0.4,2,1"};
  const ProgramResult result = Compare(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("% of the reference's area"));
  const nlohmann::json report = Report();
  const nlohmann::json& comparison = report["meshes"][0]["comparison"];
  EXPECT_NEAR(comparison["judged_share"].get<double>(), 0.4, 0.01);
  // The half that is missing is not in the box.
  EXPECT_NEAR(comparison["from_reference"]["max"].get<double>(), 0, 1e-9);

  arguments.back() = "-1,-1,-1,0.4,2";
  EXPECT_EQ(Compare(arguments).exit_code, 1);
}

TEST_F(MeshComparerTest, AlignmentIsReported) {
  std::string moved = kTetrahedron;
  moved.replace(moved.find("0 0 0\n1 0 0\n"), 12, "0 0 0.01\n1 0 0\n");
  const std::string reference = folder_.Write("ref.ply", kTetrahedron);
  const std::string mesh = folder_.Write("moved.ply", moved);
  const ProgramResult result = Compare({"--input_path",
                                        mesh,
                                        "--reference_path",
                                        reference,
                                        "--align",
                                        "1",
                                        "--Alignment.num_samples",
                                        "500",
                                        "--output_path",
                                        folder_ / "out.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("alignment"));
  const nlohmann::json report = Report();
  const nlohmann::json& alignment =
      report["meshes"][0]["comparison"]["alignment"];
  EXPECT_NEAR(alignment["scale"].get<double>(), 1, 0.05);
  EXPECT_EQ(alignment["rotation"].size(), 3u);
  EXPECT_LE(alignment["rms_after"], alignment["rms_before"]);
  EXPECT_EQ(report["meshes"][0]["audit"]["genus"], 0);
  EXPECT_EQ(report["meshes"][0]["audit"]["closed"], true);
}

TEST_F(MeshComparerTest, SameReportForAnyNumberOfThreads) {
  const std::string reference = folder_.Write("ref.ply", kTetrahedron);
  const std::string mesh = folder_.Write("square.off", Square(0.1));
  std::vector<std::string> meshes;
  for (const char* threads : {"1", "2", "4"}) {
    const ProgramResult result = Compare({"--input_path",
                                          mesh,
                                          "--reference_path",
                                          reference,
                                          "--num_threads",
                                          threads,
                                          "--output_path",
                                          folder_ / "out.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    meshes.push_back(Report()["meshes"].dump());
  }
  EXPECT_EQ(meshes[0], meshes[1]);
  EXPECT_EQ(meshes[0], meshes[2]);
}

TEST_F(MeshComparerTest, CloudsAreComparedPointByPoint) {
  const std::string reference = folder_.Write("ref.off", Square(0));
  // Two points above the square at 0.01, one beside it at 0.5.
  const std::string cloud = folder_.Write(
      "cloud.obj", "v 0.2 0.2 0.01\nv 0.8 0.5 0.01\nv 1.5 0.5 0\n");
  const ProgramResult result = Compare({"--input_path",
                                        cloud,
                                        "--reference_path",
                                        reference,
                                        "--output_path",
                                        folder_ / "out.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json to = Report()["meshes"][0]["comparison"]["to_reference"];
  EXPECT_EQ(to["samples"], 3);
  EXPECT_NEAR(to["mean"].get<double>(), (0.01 + 0.01 + 0.5) / 3, 1e-9);
  EXPECT_NEAR(to["max"].get<double>(), 0.5, 1e-9);
  // A cloud as the reference.
  ASSERT_EQ(Compare({"--input_path",
                     reference,
                     "--reference_path",
                     cloud,
                     "--output_path",
                     folder_ / "out.json"})
                .exit_code,
            0);
  const nlohmann::json from =
      Report()["meshes"][0]["comparison"]["from_reference"];
  EXPECT_NEAR(from["mean"].get<double>(), (0.01 + 0.01 + 0.5) / 3, 1e-9);
}

TEST_F(MeshComparerTest, MatricesAreWrittenAndRead) {
  const std::string reference = folder_.Write("tetra.ply", kTetrahedron);
  const std::string moved = folder_.Write("moved.obj", kMovedTetrahedron);
  const std::string matrix = folder_.Write(
      "matrix.txt", "0.5 0 0 -1.5\n0 0.5 0 0\n0 0 0.5 0\n0 0 0 1\n");
  const ProgramResult result = Compare({"--input_path",
                                        moved,
                                        "--reference_path",
                                        reference,
                                        "--transform_path",
                                        matrix,
                                        "--align",
                                        "1",
                                        "--transform_output_path",
                                        folder_ / "found.txt",
                                        "--distance_path",
                                        folder_.Path().string(),
                                        "--output_path",
                                        folder_ / "out.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_LT(Report()["meshes"][0]["comparison"]["to_reference"]["max"], 1e-6);
  std::istringstream found(ReadFile(folder_ / "found.txt"));
  const double expected[16] = {
      0.5, 0, 0, -1.5, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1};
  for (const double value : expected) {
    double number = 9;
    ASSERT_TRUE(found >> number);
    EXPECT_NEAR(number, value, 1e-4);
  }
  EXPECT_THAT(ReadFile(folder_ / "moved-distance.ply"),
              HasSubstr("property float quality\n"));
  const std::string skewed =
      folder_.Write("skewed.txt", "1 0.5 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  EXPECT_THAT(Compare({"--input_path",
                       moved,
                       "--reference_path",
                       reference,
                       "--transform_path",
                       skewed})
                  .err,
              HasSubstr("skewed.txt: the first three rows"));
}

// Four cameras that look at the tetrahedron along z, moved with it: centres
// `scale` times (i, i * i, 5), shifted by `x`.
std::string ImagesText(double scale, double x) {
  std::string text;
  for (int i = 0; i < 4; ++i) {
    const double center[3] = {scale * i + x, scale * i * i, -scale * 5};
    text += fmt::format("{} 1 0 0 0 {} {} {} 1 view{}.png\n\n",
                        i + 1,
                        -center[0],
                        -center[1],
                        -center[2],
                        i);
  }
  return text;
}

TEST_F(MeshComparerTest, MeshesAreMovedBySharedCameras) {
  const std::string reference = folder_.Write("tetra.ply", kTetrahedron);
  const std::string moved = folder_.Write("moved.obj", kMovedTetrahedron);
  const auto write_model = [&](const std::string& name,
                               const std::string& images) {
    std::filesystem::create_directories(folder_ / name / "0");
    folder_.Write(name + "/0/cameras.txt",
                  "1 PINHOLE 400 300 300 300 200 150\n");
    folder_.Write(name + "/0/images.txt", images);
    folder_.Write(name + "/0/points3D.txt", "");
    return (folder_ / name).string();
  };
  const std::string exact = write_model("exact", ImagesText(1, 0));
  const std::string mapper = write_model("mapper", ImagesText(2, 3));
  std::vector<std::string> arguments = {"--input_path",
                                        moved,
                                        "--reference_path",
                                        reference,
                                        "--min_views",
                                        "1",
                                        "--output_path",
                                        folder_ / "out.json",
                                        "--input_views_path",
                                        mapper};
  EXPECT_THAT(Compare(arguments).err, HasSubstr("needs views_path"));
  arguments.insert(arguments.end(), {"--views_path", exact});
  const ProgramResult result = Compare(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("4 photographs are in both models"));
  EXPECT_LT(Report()["meshes"][0]["comparison"]["to_reference"]["max"], 1e-6);
  EXPECT_EQ(Report()["shared_cameras"]["num_cameras"], 4);
  // Two photographs have changed places.
  std::string exchanged = ImagesText(2, 3);
  exchanged.replace(exchanged.find("view1"), 5, "viewX");
  exchanged.replace(exchanged.find("view2"), 5, "view1");
  exchanged.replace(exchanged.find("viewX"), 5, "view2");
  folder_.Write("mapper/0/images.txt", exchanged);
  EXPECT_THAT(Compare(arguments).err,
              HasSubstr("cameras of the two models probably differ"));
  folder_.Write("mapper/0/images.txt", "");
  EXPECT_THAT(Compare(arguments).err, HasSubstr("share 0 photographs"));
}

TEST_F(MeshComparerTest, MeshesOfOctacutsDepthsAreNamedSo) {
  std::filesystem::create_directory(folder_ / "stereo");
  const std::string poisson = folder_.Write("meshed-poisson.ply", kTetrahedron);
  const std::string own = folder_.Write("meshed-octahedral.ply", kTetrahedron);
  const auto name_of_poisson = [&] {
    const ProgramResult result = Compare({"--input_path",
                                          poisson + "," + own,
                                          "--reference_path",
                                          own,
                                          "--output_path",
                                          folder_ / "out.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(Report()["meshes"][1]["name"], "meshed-octahedral.ply");
    return Report()["meshes"][0]["name"].get<std::string>();
  };
  EXPECT_EQ(name_of_poisson(), "meshed-poisson.ply");
  folder_.Write("stereo/octacut-depths.json",
                R"({"source": "sweep", "kept_maps": 0})");
  EXPECT_EQ(name_of_poisson(),
            "meshed-poisson.ply (made from octacut's depths)");
  folder_.Write("stereo/octacut-depths.json",
                R"({"source": "sweep", "kept_maps": 3})");
  EXPECT_EQ(name_of_poisson(),
            "meshed-poisson.ply (made in part from octacut's depths)");
}

TEST_F(MeshComparerTest, WithoutATruthThereAreNoScores) {
  const std::string reference = folder_.Write("ref.off", Square(0));
  const std::string above = folder_.Write("above.off", Square(0.01));
  const ProgramResult result = Compare({"--input_path",
                                        above,
                                        "--reference_path",
                                        reference,
                                        "--reference_is_truth",
                                        "0",
                                        "--output_path",
                                        folder_ / "out.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, Not(HasSubstr("precision")));
  const nlohmann::json comparison = Report()["meshes"][0]["comparison"];
  EXPECT_FALSE(comparison.contains("scores"));
  EXPECT_TRUE(comparison.contains("curves"));
}

TEST_F(MeshComparerTest, MistakesAreNamed) {
  const std::string mesh = folder_.Write("mesh.ply", kTetrahedron);
  const std::string other = folder_.Write("other.ply", kTetrahedron);
  const std::string empty = folder_.Write("empty.obj", "# nothing\n");
  const std::string broken =
      folder_.Write("broken.ply", std::string(kTetrahedron, 150));
  std::filesystem::create_directory(folder_ / "d");
  struct Case {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::vector<Case> cases = {
      {{"--input_path", mesh}, "reference_path"},
      {{"--reference_path", mesh}, "input_path"},
      {{"--input_path", folder_ / "gone.ply", "--reference_path", mesh},
       "gone.ply: cannot be opened"},
      {{"--input_path", empty, "--reference_path", mesh},
       "empty.obj: has no vertices"},
      {{"--input_path",
        folder_.Write("far.off", Square(50)),
        "--reference_path",
        mesh},
       "far.off: the mesh does not overlap"},
      {{"--input_path", broken, "--reference_path", mesh}, "broken.ply: "},
      {{"--input_path", mesh, "--reference_path", mesh, "--min_views", "2"},
       "--min_views has no effect without --views_path"},
      {{"--input_path", mesh, "--reference_path", mesh, "--thresholds", "2"},
       "--thresholds = 2: must be"},
      {{"--input_path",
        mesh,
        "--reference_path",
        mesh,
        "--align",
        "1",
        "--Alignment.num_samples",
        "0"},
       "--Alignment.num_samples = 0: must be"},
      {{"--input_path",
        mesh,
        "--reference_path",
        mesh,
        "--output_path",
        folder_ / "gone" / "out.json"},
       "out.json: cannot be written"},
      {{"--input_path", mesh, "--reference_path", mesh, "--output_path", mesh},
       "--output_path = "},
      {{"--input_path", mesh + ",", "--reference_path", mesh},
       "--input_path = " + mesh + ",: must be names of files"},
      {{"--input_path", ",", "--reference_path", mesh, "--protocol", "metro"},
       "--input_path = ,: must be names of files"},
      {{"--input_path",
        mesh,
        "--reference_path",
        other,
        "--align",
        "1",
        "--transform_output_path",
        other},
       "--transform_output_path = " + other +
           ": must not be the same file as "
           "the reference"},
      {{"--input_path",
        folder_.Write("d/y.off", Square(0)),
        "--reference_path",
        folder_.Write("d/y-distance.ply", kTetrahedron),
        "--distance_path",
        folder_ / "d"},
       "must not be the same file as the reference"},
      {{"--input_path", mesh, "--reference_path", mesh, "--html_path", "p.txt"},
       "--html_path = p.txt: must end with .html or .htm"},
      {{"--input_path",
        mesh,
        "--reference_path",
        mesh,
        "--transform_path",
        folder_ / "gone.txt"},
       "gone.txt: the file cannot be read"},
      {{"--input_path",
        mesh,
        "--reference_path",
        folder_.Write("point.obj", "v 1 2 3\n")},
       "point.obj: all points lie in one place"},
  };
  for (const Case& mistake : cases) {
    const ProgramResult result = Compare(mistake.arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(mistake.message));
    EXPECT_THAT(result.out, IsEmpty());
  }
  EXPECT_EQ(ReadFile(mesh), kTetrahedron);
  EXPECT_EQ(ReadFile(other), kTetrahedron);
}

}  // namespace
}  // namespace octacut
