// mesh_refiner, and the refinement within octahedral_mesher, as a user meets
// them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_io/files/read_file.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/mesh/audit.h"
#include "plugin/report.h"
#include "tests/plugin/small_workspace.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class MeshRefiner : public testing::SmallWorkspaceTest {
 protected:
  fs::path Mesh() const { return Workspace() / "meshed-octahedral.ply"; }
  fs::path Refined() const { return Workspace() / "meshed-refined.ply"; }

  ProgramResult Refine(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"mesh_refiner",
                                          "--workspace_path",
                                          Workspace().string(),
                                          "--OctahedralMeshing.target_level",
                                          "6"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunOctacut(arguments);
  }

  // Both ways, fraction of the reference's diagonal.
  double MeanError(const fs::path& mesh) const {
    const fs::path report = folder_ / "comparison.json";
    const ProgramResult result =
        RunOctacut({"mesh_comparer",
                    "--input_path",
                    mesh.string(),
                    "--reference_path",
                    (Workspace() / "gt" / "reference.ply").string(),
                    "--num_samples",
                    "20000",
                    "--output_path",
                    report.string()});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const Json comparison =
        Json::parse(ReadFile(report))["meshes"][0]["comparison"];
    return (comparison["to_reference"]["mean_over_diagonal"].get<double>() +
            comparison["from_reference"]["mean_over_diagonal"].get<double>()) /
           2;
  }

  void ExpectError(const std::string& message,
                   const std::vector<std::string>& options) const {
    const ProgramResult result = Refine(options);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_FALSE(fs::exists(Refined()));
  }
};

TEST_F(MeshRefiner, BringsAMeshCloserToTheTruth) {
  ASSERT_EQ(RunCut().exit_code, 0);
  const ProgramResult result = Refine();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("meshed-refined.ply: "),
                    HasSubstr("vertices moved"),
                    HasSubstr("agreement of the views")));
  EXPECT_LT(MeanError(Refined()), 0.4 * MeanError(Mesh()));

  const IndexedMesh before = ReadMesh(Mesh()).mesh;
  const IndexedMesh after = ReadMesh(Refined()).mesh;
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_EQ(after.colors, before.colors);
  EXPECT_EQ(AuditMesh(after, Context(1)).DescribeFailure(), "");
  const Json report =
      Json::parse(ReadFile(Workspace() / "meshed-refined.json"));
  EXPECT_EQ(report["command"], "mesh_refiner");
  EXPECT_EQ(report["input"]["views"], testing::kSmallViews);
  EXPECT_EQ(report["audit"]["triangles"], before.triangles.size());
  EXPECT_GT(report["verdict"]["masks_as_given"]["covered"], 0.9);
  const Json& refinement = report["refinement"];
  EXPECT_EQ(refinement["vertices"], before.positions.size());
  EXPECT_GT(refinement["moved_vertices"], before.positions.size() / 2);
  EXPECT_GT(refinement["agreement_after"].get<double>(),
            refinement["agreement_before"].get<double>());
  // Four coarse ones, two fine ones, and one on smaller pieces.
  EXPECT_EQ(refinement["rounds"].size(), 7u);
}

TEST_F(MeshRefiner, GivesTheSameBytesForAnyNumberOfThreads) {
  ASSERT_EQ(RunCut().exit_code, 0);
  ASSERT_EQ(Refine({"--num_threads", "1"}).exit_code, 0);
  const std::string expected = ReadFile(Refined());
  EXPECT_GT(expected.size(), 10000u);
  ASSERT_EQ(Refine({"--num_threads", "3"}).exit_code, 0);
  EXPECT_EQ(ReadFile(Refined()), expected);
}

TEST_F(MeshRefiner, IsTheLastStepOfAReconstruction) {
  ASSERT_EQ(RunCut().exit_code, 0);
  const Json plain =
      Json::parse(ReadFile(Workspace() / "meshed-octahedral.json"));
  EXPECT_TRUE(plain["reconstruction"]["refinement"].is_null());
  ASSERT_EQ(Refine().exit_code, 0);
  const fs::path refined = folder_ / "refined.ply";
  const ProgramResult result =
      RunMesher({"--picture", "0", "--output_path", refined.string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json report = Json::parse(ReadFile(folder_ / "refined.json"));
  const Json& refinement = report["reconstruction"]["refinement"];
  EXPECT_EQ(refinement["rounds"].size(), 7u);
  EXPECT_EQ(report["options"]["Refinement"]["coarse_passes"], 2);
  // As if by hand, but for the single precision of the file between and for
  // the colours, which are those of where the vertices have gone.
  const IndexedMesh by_hand = ReadMesh(Refined()).mesh;
  const IndexedMesh mesh = ReadMesh(refined).mesh;
  ASSERT_EQ(mesh.triangles, by_hand.triangles);
  double difference = 0;
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    difference += (mesh.positions[v] - by_hand.positions[v]).norm();
  }
  EXPECT_LT(difference / double(mesh.positions.size()),
            0.01 * refinement["pixel_size"].get<double>());
  EXPECT_NE(mesh.colors, by_hand.colors);
}

TEST_F(MeshRefiner, MistakesAreNamed) {
  ExpectError("meshed-octahedral.ply: cannot be opened", {});
  const fs::path open = folder_.Write("open.off",
                                      "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n"
                                      "0 1 0\n3 0 1 2\n3 0 2 3\n");
  ExpectError("open.off: 4 boundary edge", {"--mesh_path", open.string()});
  const fs::path far =
      folder_.Write("far.off",
                    "OFF\n4 4 0\n100 0 0\n101 0 0\n100 1 0\n100 0 1\n"
                    "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  ExpectError("far.off: no two views show the mesh",
              {"--mesh_path", far.string()});
  const std::string closed = (Workspace() / "gt" / "reference.ply").string();
  for (const std::string option : {"OctahedralMeshing.mask_tolerance",
                                   "OctahedralMeshing.chroma_weight"}) {
    ExpectError("--" + option + " = -1: must be in",
                {"--mesh_path", closed, "--" + option, "-1"});
    // Other groups of the mesher's have fields of the same names.
    const ProgramResult mesher = RunMesher({"--" + option, "-1"});
    EXPECT_EQ(mesher.exit_code, 1);
    EXPECT_THAT(mesher.err, HasSubstr("--" + option + " = -1: must be in"));
  }
  for (const std::string key : {"coarse_passes", "alignment_steps"}) {
    const fs::path project =
        folder_.Write("project.ini", "[Refinement]\n" + key + " = 99\n");
    ExpectError("ERROR: Refinement." + key + " = 99: must",
                {"--mesh_path", closed, "--project_path", project.string()});
  }
  ExpectError("cannot be written",
              {"--mesh_path",
               closed,
               "--output_path",
               (folder_ / "gone" / "mesh.ply").string()});
  fs::remove(Image(3));
  ExpectError("view_003.jpg", {"--mesh_path", closed});
}

}  // namespace
}  // namespace octacut
