// The commands that reconstruct, as a user meets them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "colmap_io/files/read_file.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/mesh/audit.h"
#include "plugin/report.h"
#include "tests/plugin/small_workspace.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

std::vector<std::string> Keys(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) {
    keys.push_back(key);
  }
  return keys;
}

// That the page describes all members, of arrays those of the first element.
void ExpectDocumented(const Json& object, const std::string& page) {
  for (const auto& [key, value] : object.items()) {
    EXPECT_THAT(page, HasSubstr("`" + key + "`"));
    const Json& inner = value.is_array() && !value.empty() ? value[0] : value;
    if (inner.is_object() && key != "options") {
      ExpectDocumented(inner, page);
    }
  }
}

class OctahedralMesher : public testing::SmallWorkspaceTest {
 protected:
  fs::path Result(const std::string& ending) const {
    return Workspace() / ("meshed-octahedral" + ending);
  }
};

TEST_F(OctahedralMesher, LeavesMeshReportAndPicture) {
  const ProgramResult result = RunMesher();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("meshed-octahedral.ply: "));
  EXPECT_THAT(result.out,
              HasSubstr("closed 2-manifold with 1 component, genus 1"));

  const IndexedMesh mesh = ReadMesh(Result(".ply")).mesh;
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.colors.size(), mesh.positions.size());
  EXPECT_EQ(AuditMesh(mesh, Context(1)).DescribeFailure(), "");

  const Json report = Json::parse(ReadFile(Result(".json")));
  ExpectDocumented(
      report, ReadFile(fs::path(OCTACUT_SOURCE_DIR) / "docs" / "report.md"));
  EXPECT_THAT(Keys(report),
              IsSupersetOf({"version",
                            "options",
                            "phases",
                            "seconds",
                            "peak_memory_bytes",
                            "input",
                            "warnings",
                            "reconstruction",
                            "audit",
                            "verdict"}));
  EXPECT_EQ(report["input"]["views"], testing::kSmallViews);
  const Json& levels = report["reconstruction"]["levels"];
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[1]["resolution"], 64);
  EXPECT_THAT(Keys(levels[1]),
              IsSupersetOf({"crust_voxels",
                            "graph_nodes",
                            "cut_cost",
                            "crust_seconds",
                            "visibility_seconds",
                            "consistency_seconds",
                            "cut_seconds"}));
  EXPECT_THAT(Keys(report["audit"]),
              IsSupersetOf({"vertices",
                            "triangles",
                            "closed",
                            "edge_manifold",
                            "vertex_manifold",
                            "oriented",
                            "components",
                            "genus",
                            "area",
                            "volume",
                            "bounding_box"}));
  EXPECT_EQ(report["audit"]["triangles"], mesh.triangles.size());
  const Json& masks = report["verdict"]["masks_as_given"];
  EXPECT_GT(masks["covered"], 0.9);
  EXPECT_LT(masks["surely_exceeded"], 0.01);
  EXPECT_EQ(masks["views"].size(), size_t{testing::kSmallViews});
  EXPECT_THAT(result.err, HasSubstr("Silhouettes: the mesh covers "));
  EXPECT_FALSE(cv::imread(Result(".png").string()).empty());
}

TEST_F(OctahedralMesher, IsInTheFrameOfTheModel) {
  ASSERT_EQ(RunMesher({"--picture", "0"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(Result(".png")));
  const MeshAudit mesh = AuditMesh(ReadMesh(Result(".ply")).mesh, Context(1));
  const MeshAudit reference = AuditMesh(
      ReadMesh(Workspace() / "gt" / "reference.ply").mesh, Context(1));
  EXPECT_NEAR(mesh.volume, reference.volume, 0.15 * reference.volume);
  const double voxel =
      Json::parse(ReadFile(Result(".json")))["input"]["region"]["cube_edge"]
          .get<double>() /
      64;
  for (const auto& [corner, expected] :
       {std::pair(mesh.bounding_box.min(), reference.bounding_box.min()),
        std::pair(mesh.bounding_box.max(), reference.bounding_box.max())}) {
    EXPECT_LT((corner - expected).cwiseAbs().maxCoeff(), 1.5 * voxel);
  }
}

TEST_F(OctahedralMesher, GivesTheSameBytesForAnyNumberOfThreads) {
  const auto run = [&](const std::string& num_threads) {
    const std::string folder = (folder_ / num_threads).string();
    fs::create_directory(folder);
    const ProgramResult result = RunMesher({"--num_threads",
                                            num_threads,
                                            "--save_levels",
                                            folder,
                                            "--output_path",
                                            folder + "/mesh.ply"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::vector<std::string> files;
    for (const char* name :
         {"mesh.ply", "mesh.png", "hull.ply", "level_05.ply", "level_06.ply"}) {
      files.push_back(ReadFile(folder_ / num_threads / name));
      EXPECT_GT(files.back().size(), 1000u) << name;
    }
    return files;
  };
  const std::vector<std::string> expected = run("1");
  EXPECT_EQ(run("2"), expected);
  EXPECT_EQ(run("4"), expected);
}

TEST_F(OctahedralMesher, ConfidenceIsInTheMeshAndComparedOnRequest) {
  const fs::path path = folder_ / "mesh.ply";
  const ProgramResult result = RunMesher(
      {"--picture", "0", "--confidence", "1", "--output_path", path.string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const IndexedMesh mesh = ReadMesh(path).mesh;
  ASSERT_EQ(mesh.confidence.size(), mesh.positions.size());
  const auto [least, most] =
      std::minmax_element(mesh.confidence.begin(), mesh.confidence.end());
  EXPECT_GT(*least, 0);
  EXPECT_LT(*least, *most);
  EXPECT_LE(*most, 1);
  const Json report = Json::parse(ReadFile(folder_ / "mesh.json"));
  EXPECT_GT(report["verdict"]["surface"]["decided_by_photographs"], 0.3);
  EXPECT_FALSE(report["verdict"]["findings"].empty());

  const ProgramResult comparison = RunOctacut({"mesh_comparer",
                                               "--input_path",
                                               path.string(),
                                               "--reference_path",
                                               path.string(),
                                               "--num_samples",
                                               "1000"});
  ASSERT_EQ(comparison.exit_code, 0) << comparison.err;
  EXPECT_THAT(comparison.out, HasSubstr("least confident tenth"));

  const ProgramResult refused = RunMesher(
      {"--confidence", "1", "--output_path", (folder_ / "m.obj").string()});
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_THAT(refused.err, HasSubstr("--confidence"));
}

TEST_F(OctahedralMesher, WritesTheFormatOfTheExtension) {
  for (const char* extension : {".ply", ".obj", ".off", ".stl"}) {
    const fs::path path = folder_ / (std::string("mesh") + extension);
    const ProgramResult result = RunCut({"--output_path", path.string()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const size_t triangles =
        Json::parse(ReadFile(folder_ / "mesh.json"))["audit"]["triangles"];
    EXPECT_EQ(ReadMesh(path).mesh.triangles.size(), triangles) << extension;
  }
}

TEST_F(OctahedralMesher, SavedLevelsAreClosed) {
  const fs::path levels = folder_ / "new" / "levels";
  ASSERT_EQ(RunCut({"--save_levels", levels.string()}).exit_code, 0);
  for (const char* name : {"hull.ply", "level_05.ply", "level_06.ply"}) {
    const MeshAudit audit = AuditMesh(ReadMesh(levels / name).mesh, Context(1));
    EXPECT_EQ(audit.DescribeFailure(), "") << name;
  }
  const ProgramResult result = RunMesher({"--save_levels",
                                          levels.string(),
                                          "--output_path",
                                          levels / "level_05.ply"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err,
              HasSubstr("must not be the same file as a mesh of save_levels"));
}

TEST_F(OctahedralMesher, CommandLineWinsOverProjectFile) {
  const fs::path project = folder_.Write("project.ini",
                                         "picture = 0\n"
                                         "[OctahedralMeshing]\n"
                                         "area_weight = 2e-5\n"
                                         "target_level = 9\n");
  const ProgramResult result = RunMesher({"--project_path", project.string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json options = Json::parse(ReadFile(Result(".json")))["options"];
  EXPECT_EQ(options["picture"], false);
  EXPECT_EQ(options["OctahedralMeshing"]["area_weight"], 2e-5);
  EXPECT_EQ(options["OctahedralMeshing"]["target_level"], 6);
}

TEST_F(OctahedralMesher, EveryConsistencyReconstructs) {
  for (const char* kind : {"normalized_variance", "ncc", "variance"}) {
    // Two pixels of these small images are more than a voxel; the plain
    // variance then leaves a handle.
    const ProgramResult result = RunCut({"--OctahedralMeshing.mask_tolerance",
                                         "0",
                                         "--OctahedralMeshing.consistency",
                                         kind});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("with 1 component, genus 1")) << kind;
  }
}

TEST_F(OctahedralMesher, ErrorsNameOptionsAndKeys) {
  const ProgramResult option =
      RunMesher({"--OctahedralMeshing.ballooning", "-1"});
  EXPECT_EQ(option.exit_code, 1);
  EXPECT_THAT(option.err,
              HasSubstr("ERROR: --OctahedralMeshing.ballooning = -1: must"));
  const fs::path project =
      folder_.Write("project.ini", "[DepthSweep]\nnum_neighbors = 1\n");
  const ProgramResult key = RunMesher({"--project_path", project.string()});
  EXPECT_EQ(key.exit_code, 1);
  EXPECT_THAT(key.err, HasSubstr("ERROR: DepthSweep.num_neighbors = 1: must"));
  EXPECT_FALSE(fs::exists(Result(".ply")));
}

// The log of a run that nobody watches.
TEST_F(OctahedralMesher, LogIsShortAndSaysWhatWasChosen) {
  const ProgramResult result = RunMesher({"--quality", "low"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_LE(std::count(result.err.begin(), result.err.end(), '\n'), 40)
      << result.err;
  EXPECT_EQ(result.err.rfind("Quality low with the given "
                             "--OctahedralMeshing.target_level: 64^3 voxels "
                             "(level 6), without refinement.\n",
                             0),
            0u)
      << result.err;
  EXPECT_THAT(result.err,
              HasSubstr("images of the sparse model " +
                        (Workspace() / "sparse" / "0").string()));
  EXPECT_THAT(result.err,
              HasSubstr("Wrote the report to " + Result(".json").string() +
                        ", the picture to " + Result(".png").string()));
  EXPECT_THAT(result.err, ContainsRegex("The run took [0-9.]+ s and at most "));
  const Json report = Json::parse(ReadFile(Result(".json")));
  EXPECT_EQ(report["options"]["quality"], "low");
  EXPECT_EQ(report["options"]["OctahedralMeshing"]["refine"], false);
  EXPECT_TRUE(report["reconstruction"]["refinement"].is_null());
}

TEST_F(OctahedralMesher, VisualHullAlone) {
  fs::remove_all(Workspace() / "images");  // masks are enough
  fs::create_directories(Workspace() / "images");
  const ProgramResult result = RunOctacut({"visual_hull_mesher",
                                           "--workspace_path",
                                           Workspace().string(),
                                           "--OctahedralMeshing.hull_level",
                                           "6"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const MeshAudit audit = AuditMesh(
      ReadMesh(Workspace() / "meshed-visual-hull.ply").mesh, Context(1));
  EXPECT_EQ(audit.DescribeFailure(), "");
  EXPECT_EQ(audit.genus, 1);
  const Json report =
      Json::parse(ReadFile(Workspace() / "meshed-visual-hull.json"));
  EXPECT_EQ(report["audit"]["triangles"], audit.num_triangles);
  EXPECT_GT(report["verdict"]["masks_as_repaired"]["covered"], 0.98);
  EXPECT_THAT(result.err, HasSubstr("Silhouettes: the mesh covers "));
}

}  // namespace
}  // namespace octacut
