#include "plugin/example_workspace.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "colmap_io/files/read_file.h"
#include "colmap_io/mesh/mesh_io.h"
#include "colmap_io/model/camera_models.h"
#include "colmap_io/model/camera_projector.h"
#include "colmap_io/model/read_sparse_model.h"
#include "core/base/error.h"
#include "plugin/report.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<std::string> QuickExample(const fs::path& folder) {
  return {"example_creator",
          "--output_path",
          folder.string(),
          "--scene",
          "torus",
          "--num_views",
          "5",
          "--width",
          "96",
          "--height",
          "64",
          "--num_points",
          "200",
          "--reference_resolution",
          "40",
          "--Rig.k1",
          "-0.1"};
}

TEST(ToSparseModel, ObservationsAreWhereItsCamerasSeeThePoints) {
  for (const double k1 : {0.0, -0.1}) {
    SceneSpec spec = QuickScene("sphere", 96, 64, 6);
    spec.reference.resolution = 30;
    spec.rig.k1 = k1;
    const SyntheticScene scene = MakeScene(spec, Context());
    const SparseModel model = ToSparseModel(scene);
    EXPECT_NO_THROW(CheckSparseModel(model));
    ASSERT_EQ(model.cameras.size(), 1u);
    EXPECT_EQ(IsUndistorted(model.cameras[0]), k1 == 0);
    ASSERT_EQ(model.points.size(), scene.points.size());
    ASSERT_GT(model.points.size(), 50u);
    size_t num_observations = 0;
    for (const SparsePoint& point : model.points) {
      EXPECT_LT(point.error, 1e-6);
      for (const auto& [image_id, index] : point.track) {
        const SparseImage& image = model.images[image_id - 1];
        const SparseObservation& observation = image.observations[index];
        EXPECT_EQ(observation.point3D_id, point.id);
        const auto pixel = CameraProjector(model.cameras[0])
                               .ImgFromCam(image.CamFromWorld() * point.xyz);
        ASSERT_TRUE(pixel.has_value());
        EXPECT_NEAR(pixel->x(), observation.x, 1e-6);
        EXPECT_NEAR(pixel->y(), observation.y, 1e-6);
        ++num_observations;
      }
    }
    EXPECT_GE(num_observations, 2 * model.points.size());
  }
}

TEST(ExampleCreator, WritesAWorkspaceThatCanBeReadBack) {
  const TemporaryFolder folder;
  const fs::path workspace = folder / "with blanks" / "w";
  const ProgramResult result = RunOctacut(QuickExample(workspace));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const SparseModel model = ReadSparseModel(workspace / "sparse" / "0");
  ASSERT_EQ(model.images.size(), 5u);
  for (const SparseImage& image : model.images) {
    const cv::Mat photograph =
        cv::imread((workspace / "images" / image.name).string());
    const cv::Mat mask =
        cv::imread((workspace / "masks" / (image.name + ".png")).string(),
                   cv::IMREAD_UNCHANGED);
    EXPECT_EQ(photograph.size(), cv::Size(96, 64));
    EXPECT_EQ(mask.size(), cv::Size(96, 64));
    EXPECT_EQ(mask.type(), CV_8UC1);
    EXPECT_GT(cv::countNonZero(mask == 255), 200);
    EXPECT_GT(cv::countNonZero(mask == 0), 200);
  }
  const MeshFile reference = ReadMesh(workspace / "gt" / "reference.ply");
  EXPECT_GT(reference.mesh.triangles.size(), 1000u);
  EXPECT_EQ(reference.mesh.colors.size(), reference.mesh.positions.size());
  const Json report = Json::parse(ReadFile(workspace / kExampleReportName));
  EXPECT_EQ(report["complete"], true);
  EXPECT_EQ(report["reference"]["genus"], 1);
  EXPECT_EQ(report["options"]["Rig"]["k1"], -0.1);
}

TEST(ExampleCreator, PhotographsAMeshFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(RunOctacut(QuickExample(folder / "torus")).exit_code, 0);
  const fs::path mesh_path = folder / "torus" / "gt" / "reference.ply";
  std::vector<std::string> arguments = QuickExample(folder / "w");
  std::replace(arguments.begin(),
               arguments.end(),
               std::string("torus"),
               std::string("sphere"));
  arguments.insert(arguments.end(), {"--mesh_path", mesh_path.string()});
  const ProgramResult result = RunOctacut(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json report = Json::parse(ReadFile(folder / "w" / kExampleReportName));
  EXPECT_EQ(report["reference"]["genus"], 1);
  EXPECT_EQ(ReadMesh(folder / "w" / "gt" / "reference.ply").mesh.triangles,
            ReadMesh(mesh_path).mesh.triangles);
}

TEST(ExampleCreator, RejectsAnOpenMesh) {
  const TemporaryFolder folder;
  folder.Write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  std::vector<std::string> arguments = QuickExample(folder / "w");
  arguments.insert(arguments.end(),
                   {"--mesh_path", (folder / "open.off").string()});
  const ProgramResult result = RunOctacut(arguments);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("open.off: "));
  EXPECT_FALSE(fs::exists(folder / "w"));
}

TEST(ExampleCreator, NeverDestroysWhatIsNoExample) {
  const TemporaryFolder folder;
  folder.Write("thesis.tex", "years of work");
  std::vector<std::string> arguments = QuickExample(folder.Path());
  EXPECT_THAT(RunOctacut(arguments).err,
              HasSubstr("not an example of octacut"));
  arguments.insert(arguments.end(), {"--overwrite", "1"});
  const ProgramResult result = RunOctacut(arguments);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("not an example of octacut"));
  EXPECT_EQ(ReadFile(folder / "thesis.tex"), "years of work");
}

TEST(ExampleCreator, ReplacesAnEarlierExampleOnlyWhenTold) {
  const TemporaryFolder folder;
  const ExampleWorkspaceOptions keep;
  ExampleWorkspaceOptions replace;
  replace.overwrite = true;
  const fs::path workspace = folder / "w";
  EXPECT_NO_THROW(PrepareExampleFolder(workspace, keep));
  EXPECT_NO_THROW(PrepareExampleFolder(workspace, keep)) << "still empty";
  folder.Write(std::string("w/") + kExampleReportName, "{}");
  fs::create_directories(workspace / "images");
  folder.Write("w/images/stale.jpg", "");
  folder.Write("w/meshed-octahedral.ply", "");
  EXPECT_THROW(PrepareExampleFolder(workspace, keep), InputError);
  PrepareExampleFolder(workspace, replace);
  EXPECT_FALSE(fs::exists(workspace / "images" / "stale.jpg"));
  EXPECT_TRUE(fs::exists(workspace / "meshed-octahedral.ply"));
  folder.Write("file", "");
  EXPECT_THROW(PrepareExampleFolder(folder / "file", replace), InputError);
}

TEST(ExampleCreator, KeepsAnEarlierExampleIfItFails) {
  const TemporaryFolder folder;
  const fs::path workspace = folder / "w";
  ASSERT_EQ(RunOctacut(QuickExample(workspace)).exit_code, 0);
  const fs::path mesh = workspace / "gt" / "reference.ply";
  std::vector<std::string> arguments = QuickExample(workspace);
  // A camera below the stand.
  arguments.insert(
      arguments.end(),
      {"--overwrite", "1", "--Scene.stand", "1", "--Rig.min_elevation", "-80"});
  EXPECT_EQ(RunOctacut(arguments).exit_code, 1);
  EXPECT_TRUE(fs::exists(mesh));
  arguments = QuickExample(workspace);
  arguments.insert(arguments.end(),
                   {"--overwrite", "1", "--mesh_path", mesh.string()});
  EXPECT_THAT(RunOctacut(arguments).err,
              HasSubstr("must not lie in output_path"));
  EXPECT_TRUE(fs::exists(mesh));
}

TEST(ExampleCreator, RefusesBadValuesBeforeItTouchesTheFolder) {
  const TemporaryFolder folder;
  const fs::path workspace = folder / "w";
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{
           {"scene", "teapot"},
           {"num_views", "0"},
           {"width", "-5"},
           {"image_extension", ".gif"},
           {"jpeg_quality", "101"},
           {"Rig.kind", "random"},
           {"Scene.specular", "1001"},
           {"Degrade.mask_defect_radius", "2000"},
           {"num_threads", "100000"},
           {"Degrade.pixel_noise", "-1"}}) {
    const ProgramResult result = RunOctacut({"example_creator",
                                             "--output_path",
                                             workspace.string(),
                                             "--" + option,
                                             value});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(
        result.err,
        HasSubstr(fmt::format("ERROR: --{} = {}: must", option, value)));
    EXPECT_FALSE(fs::exists(workspace));
  }
}

}  // namespace
}  // namespace octacut
