// mesh_auditor as a user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "colmap_io/files/read_file.h"
#include "colmap_io/mesh/mesh_io.h"
#include "tests/core/print/print_shapes.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class MeshAuditorTest : public ::testing::Test {
 protected:
  ProgramResult Audit(const IndexedMesh& mesh,
                      std::vector<std::string> arguments = {}) const {
    WriteMesh(folder_ / "mesh.stl", mesh);
    return Run((folder_ / "mesh.stl").string(),
               (folder_ / "audit.json").string(),
               std::move(arguments));
  }
  static ProgramResult Run(const std::string& input,
                           const std::string& output,
                           std::vector<std::string> arguments = {}) {
    arguments.insert(
        arguments.begin(),
        {"mesh_auditor", "--input_path", input, "--output_path", output});
    return RunOctacut(arguments);
  }
  nlohmann::json Report() const {
    return nlohmann::json::parse(ReadFile(folder_ / "audit.json"));
  }

  TemporaryFolder folder_;
};

TEST_F(MeshAuditorTest, OneSkinHasNoWall) {
  const ProgramResult result =
      Audit(HeightField(2, [](double, double) { return 0.0; }));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json report = Report();
  EXPECT_EQ(report["wall_thickness"]["measured_share"], 0);
  EXPECT_TRUE(report["wall_thickness"]["min"].is_null());
}

TEST_F(MeshAuditorTest, ABoxWithAWall) {
  const ProgramResult result =
      Audit(BoxWithWall(4, 0.1), {"--min_wall", "0.2"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("watertight"));
  EXPECT_THAT(result.out, Not(HasSubstr("NO")));
  EXPECT_THAT(result.err, HasSubstr("walls are thinner than 0.2 on 78."));
  const nlohmann::json report = Report();
  EXPECT_EQ(report["mesh"]["audit"]["closed"], true);
  EXPECT_EQ(report["mesh"]["audit"]["components"], 2);
  EXPECT_EQ(report["mesh"]["self_intersections"]["pairs"], 0);
  EXPECT_NEAR(report["mesh"]["audit"]["volume"], 1 - 0.512, 0.01 * 0.488);
  EXPECT_NEAR(report["mesh"]["audit"]["area"], 6 + 6 * 0.64, 0.01 * 9.84);
  EXPECT_NEAR(report["wall_thickness"]["min"], 0.1, 0.001);
  EXPECT_NEAR(report["wall_thickness"]["thin_share"], 1.28 / 1.64, 0.01);
  EXPECT_EQ(report["wall_thickness"]["histogram"].size(), 20u);
  EXPECT_EQ(report["wall_thickness"]["thinnest"][0]["point"].size(), 3u);
  EXPECT_NEAR(report["overhangs"]["share"], 0.64 / 9.84, 0.001);
  EXPECT_NEAR(report["overhangs"]["base_area"], 1, 1e-6);
}

TEST_F(MeshAuditorTest, UpMatters) {
  IndexedMesh pyramid = Cube(4);
  for (Eigen::Vector3d& p : pyramid.positions) {
    p.head<2>() = (p.head<2>() - Eigen::Vector2d(0.5, 0.5)) * (1 - 0.9 * p.z());
  }
  EXPECT_EQ(Audit(pyramid).exit_code, 0);
  EXPECT_EQ(Report()["overhangs"]["share"], 0);
  EXPECT_EQ(
      Audit(pyramid, {"--up", "0,0,-1", "--max_overhang", "20"}).exit_code, 0);
  EXPECT_GT(Report()["overhangs"]["share"], 0.5);
}

TEST_F(MeshAuditorTest, DefectsAreWarnings) {
  IndexedMesh mesh = Joined(Sphere(6), Moved(Sphere(6), {1, 0.1, 0.2}));
  mesh.triangles.pop_back();
  const ProgramResult result = Audit(mesh);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("NO"));
  EXPECT_THAT(result.err, HasSubstr("3 boundary edges"));
  EXPECT_THAT(result.err, HasSubstr("pairs of triangles intersect"));
}

TEST_F(MeshAuditorTest, MistakesAreNamed) {
  struct Case {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::vector<Case> cases = {
      {{"--up", "0,0,0"}, "--up = 0,0,0: "},
      {{"--up", "up"}, "--up"},
      {{"--max_overhang", "90"}, "--max_overhang = 90: "},
      {{"--min_wall", "-1"}, "--min_wall = -1: "},
      {{"--num_samples", "1"}, "--num_samples = 1: "},
  };
  for (const Case& mistake : cases) {
    const ProgramResult result = Audit(Cube(2), mistake.arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(mistake.message));
    EXPECT_THAT(result.out, IsEmpty());
  }
  const std::string mesh = (folder_ / "mesh.stl").string();
  const std::string report = (folder_ / "audit.json").string();
  EXPECT_THAT(Run((folder_ / "gone.ply").string(), report).err,
              HasSubstr("gone.ply: cannot be opened"));
  EXPECT_THAT(Run(folder_.Write("part.3mf", "PK"), report).err,
              HasSubstr("part.3mf: 3MF can be written, but not read"));
  EXPECT_THAT(Run(mesh, mesh).err, HasSubstr("--output_path = "));
  EXPECT_THAT(Run(folder_.Write("flat.off",
                                "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n"
                                "3 0 1 2\n"),
                  report)
                  .err,
              HasSubstr("flat.off: its triangles have no area"));
}

}  // namespace
}  // namespace octacut
