// depth_map_renderer as a user meets it.
#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "colmap_io/files/read_file.h"
#include "colmap_io/mesh/mesh_io.h"
#include "tests/colmap_io/images/read_dense_map.h"
#include "tests/plugin/small_workspace.h"

namespace octacut::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class DepthMapRendererTest : public SmallWorkspaceTest {
 protected:
  // The example's cameras are pinholes: with these folders its workspace is an
  // undistorted one.
  void MakeStereoFolders() const {
    fs::create_directories(Workspace() / "stereo" / "depth_maps");
    fs::create_directories(Workspace() / "stereo" / "normal_maps");
  }
  ProgramResult Render(std::vector<std::string> arguments) const {
    arguments.insert(
        arguments.begin(),
        {"depth_map_renderer", "--workspace_path", Workspace().string()});
    return RunOctacut(arguments);
  }
  fs::path Map(const std::string& kind) const {
    return Workspace() / "stereo" / kind / "view_003.jpg.geometric.bin";
  }
  std::string Truth() const {
    return (Workspace() / "gt" / "reference.ply").string();
  }
};

TEST_F(DepthMapRendererTest, TheMeshAndTheSweepAgree) {
  // Neighbours must be near enough to look alike: more views than others need.
  fs::remove_all(Workspace());
  const ProgramResult example = RunOctacut({"example_creator",
                                            "--output_path",
                                            Workspace().string(),
                                            "--scene",
                                            "torus",
                                            "--num_views",
                                            "36",
                                            "--width",
                                            std::to_string(kSmallWidth),
                                            "--height",
                                            std::to_string(kSmallHeight),
                                            "--reference_resolution",
                                            "40"});
  ASSERT_EQ(example.exit_code, 0) << example.err;
  MakeStereoFolders();
  const ProgramResult mesh = Render({"--mesh_path", Truth()});
  ASSERT_EQ(mesh.exit_code, 0) << mesh.err;
  EXPECT_THAT(mesh.out, HasSubstr("36 depth maps"));
  const cv::Mat truth = ReadDenseMap(Map("depth_maps"));
  const cv::Mat normals = ReadDenseMap(Map("normal_maps"));
  ASSERT_EQ(truth.size(), cv::Size(kSmallWidth, kSmallHeight));
  ASSERT_EQ(normals.channels(), 3);
  EXPECT_GT(cv::countNonZero(truth), 2000);
  // Maps that exist are kept ...
  const ProgramResult kept = Render({"--source", "sweep"});
  ASSERT_EQ(kept.exit_code, 0) << kept.err;
  EXPECT_THAT(kept.out, HasSubstr("0 depth maps"));
  EXPECT_THAT(kept.out, HasSubstr("36 kept"));
  // ... unless they are to be replaced.
  const ProgramResult sweep =
      Render({"--source", "sweep", "--overwrite", "1", "--sweep_level", "6"});
  ASSERT_EQ(sweep.exit_code, 0) << sweep.err;
  const cv::Mat swept = ReadDenseMap(Map("depth_maps"));
  const cv::Mat swept_normals = ReadDenseMap(Map("normal_maps"));
  int num_both = 0;
  int num_near = 0;
  int num_facing = 0;
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      const float a = truth.at<float>(y, x);
      const float b = swept.at<float>(y, x);
      if (b > 0 && a > 0) {
        ++num_both;
        num_near += std::abs(a - b) < 0.02f * a;
        num_facing += normals.at<cv::Vec3f>(y, x).dot(
                          swept_normals.at<cv::Vec3f>(y, x)) > 0.8f;
      }
    }
  }
  ASSERT_GT(num_both, 300);
  EXPECT_GT(num_near, 0.9 * num_both);
  EXPECT_GT(num_facing, 0.7 * num_both);
  EXPECT_THAT(ReadFile(Workspace() / "stereo" / "octacut-depths.json"),
              HasSubstr("\"sweep\""));
}

TEST_F(DepthMapRendererTest, OnlyTheMissingMapOfAPairIsWritten) {
  MakeStereoFolders();
  ASSERT_EQ(Render({"--mesh_path", Truth()}).exit_code, 0);
  folder_.Write("w/stereo/depth_maps/view_003.jpg.geometric.bin", "precious");
  fs::remove(Map("normal_maps"));
  const ProgramResult result = Render({"--mesh_path", Truth()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(ReadFile(Map("depth_maps")), "precious");
  EXPECT_TRUE(fs::exists(Map("normal_maps")));
  // Maps of the earlier run are octacut's, too.
  EXPECT_THAT(ReadFile(Workspace() / "stereo" / "octacut-depths.json"),
              HasSubstr("\"kept_maps\": 0"));
}

TEST_F(DepthMapRendererTest, AFailedRunLeavesNoLabel) {
  MakeStereoFolders();
  IndexedMesh away = ReadMesh(Truth()).mesh;
  for (Eigen::Vector3d& position : away.positions) {
    position += Eigen::Vector3d(300, 500, 100);
  }
  WriteMesh(folder_ / "away.ply", away);
  EXPECT_THAT(Render({"--mesh_path", (folder_ / "away.ply").string()}).err,
              HasSubstr("away.ply: none of the 12 photographs shows"));
  // Seen, but as a point.
  IndexedMesh tiny = ReadMesh(Truth()).mesh;
  for (Eigen::Vector3d& position : tiny.positions) {
    position *= 1e-6;
  }
  WriteMesh(folder_ / "tiny.ply", tiny);
  EXPECT_THAT(Render({"--mesh_path", (folder_ / "tiny.ply").string()}).err,
              HasSubstr("tiny.ply: none of the 12 photographs shows 100 pix"));
  EXPECT_EQ(Render({"--mesh_path", (folder_ / "gone.ply").string()}).exit_code,
            1);
  EXPECT_FALSE(fs::exists(Workspace() / "stereo" / "octacut-depths.json"));
}

TEST_F(DepthMapRendererTest, MistakesAreNamed) {
  EXPECT_THAT(Render({"--mesh_path", Truth()}).err,
              HasSubstr("must be an undistorted workspace"));
  MakeStereoFolders();
  EXPECT_THAT(Render({}).err, HasSubstr("--mesh_path = "));
  EXPECT_THAT(Render({"--source", "sweep", "--mesh_path", Truth()}).err,
              HasSubstr("--mesh_path = "));
  EXPECT_THAT(Render({"--mesh_path", Truth(), "--sweep_level", "6"}).err,
              HasSubstr("--sweep_level has no effect without --source sweep"));
  EXPECT_EQ(Render({"--mesh_path", Truth()}).exit_code, 0);
  EXPECT_THAT(Render({"--mesh_path", "/gone.ply"}).err,
              HasSubstr("/gone.ply: cannot be opened"));
  const std::string points = folder_.Write("points.obj", "v 0 0 0\nv 1 1 1\n");
  EXPECT_THAT(Render({"--mesh_path", points}).err,
              HasSubstr("points.obj: the mesh has no faces"));
}

}  // namespace
}  // namespace octacut::testing
