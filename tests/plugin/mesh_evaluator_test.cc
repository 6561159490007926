// mesh_evaluator as a user meets it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "colmap_io/files/read_file.h"
#include "tests/plugin/small_workspace.h"

namespace octacut::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class MeshEvaluatorTest : public SmallWorkspaceTest {
 protected:
  ProgramResult Evaluate(std::vector<std::string> arguments) const {
    arguments.insert(
        arguments.begin(),
        {"mesh_evaluator", "--workspace_path", Workspace().string()});
    return RunOctacut(arguments);
  }
  std::string Truth() const {
    return (Workspace() / "gt" / "reference.ply").string();
  }
  nlohmann::json Report() const {
    return nlohmann::json::parse(ReadFile(folder_ / "out.json"));
  }
};

TEST_F(MeshEvaluatorTest, TableAndReport) {
  const ProgramResult result =
      Evaluate({"--mesh_path", Truth(), "--output_path", folder_ / "out.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("reference.ply "));
  EXPECT_THAT(result.out, HasSubstr("correlation: mean"));
  const nlohmann::json report = Report();
  EXPECT_EQ(report["command"], "mesh_evaluator");
  EXPECT_EQ(report["input"]["views"], kSmallViews);
  const nlohmann::json& mesh = report["meshes"][0];
  EXPECT_EQ(mesh["audit"]["genus"], 1);
  EXPECT_EQ(mesh["self_intersections"]["triangles"], 0);
  const nlohmann::json& silhouettes = mesh["silhouettes"];
  EXPECT_GT(silhouettes["intersection_over_union"].get<double>(), 0.99);
  EXPECT_LT(silhouettes["outline_mean"].get<double>(), 0.1);
  EXPECT_EQ(silhouettes["views"].size(), size_t(kSmallViews));
  EXPECT_EQ(silhouettes["views"][0]["name"], "view_000.jpg");
  EXPECT_GT(mesh["reprojection"]["mean_correlation"].get<double>(), 0.5);
}

TEST_F(MeshEvaluatorTest, SilhouettesAloneNeedNoPhotographs) {
  std::filesystem::remove(Image(0));
  EXPECT_EQ(Evaluate({"--mesh_path", Truth()}).exit_code, 1);
  const ProgramResult result =
      Evaluate({"--mesh_path", Truth(), "--photometric", "0"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, Not(HasSubstr("correlation")));
}

TEST_F(MeshEvaluatorTest, MistakesAreNamed) {
  const std::string points = folder_.Write("points.obj", "v 0 0 0\nv 1 1 1\n");
  EXPECT_THAT(Evaluate({}).err, HasSubstr("mesh_path"));
  EXPECT_THAT(Evaluate({"--mesh_path", points}).err,
              HasSubstr("points.obj: the mesh has no faces"));
  const std::string away =
      folder_.Write("away.obj", "v 900 0 0\nv 901 0 0\nv 900 1 0\nf 1 2 3\n");
  EXPECT_THAT(Evaluate({"--mesh_path", away}).err,
              HasSubstr("away.obj: no view shows the mesh"));
  EXPECT_THAT(Evaluate({"--mesh_path", Truth(), "--output_path", Truth()}).err,
              HasSubstr("--output_path = "));
  EXPECT_THAT(Evaluate({"--mesh_path", Truth(), "--image_level", "0"}).err,
              HasSubstr("--image_level = 0: must be in 1 .. 20"));
}

}  // namespace
}  // namespace octacut::testing
