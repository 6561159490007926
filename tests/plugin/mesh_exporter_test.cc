// mesh_exporter as a user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <numbers>
#include <opencv2/imgcodecs.hpp>

#include "colmap_io/files/read_file.h"
#include "colmap_io/mesh/mesh_io.h"
#include "colmap_io/model/write_sparse_model.h"
#include "core/mesh/audit.h"
#include "tests/core/mesh/test_shapes.h"
#include "tests/core/print/marker_images.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int kViews = 8;

class MeshExporterTest : public ::testing::Test {
 protected:
  MeshExporterTest() {
    // Stands on the plane z = 0.
    mesh_ = Moved(Sphere(16, 0.3), {0, 0, 0.3});
    for (const Eigen::Vector3d& p : mesh_.positions) {
      mesh_.colors.push_back({uint8_t(128 + 200 * p.x()), 10, 20});
    }
    WriteMesh(folder_ / "mesh.ply", mesh_);
  }

  // To out.stl, or to where the arguments say first.
  ProgramResult Export(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = {
        "mesh_exporter", "--input_path", Path("mesh.ply")};
    if (arguments.empty() || arguments[0] != "--output_path") {
      all.insert(all.end(), {"--output_path", Path("out.stl")});
    }
    all.insert(all.end(), arguments.begin(), arguments.end());
    return RunOctacut(all);
  }
  std::string Path(const std::string& name) const {
    return (folder_ / name).string();
  }
  nlohmann::json Report(const std::string& name = "out.stl.json") const {
    return nlohmann::json::parse(ReadFile(folder_ / name));
  }
  MeshAudit AuditOf(const std::string& name = "out.stl") const {
    return AuditMesh(ReadMesh(folder_ / name).mesh, Context(1));
  }

  // Photographs from around with two markers beside the object, and points of
  // the table.
  void MakeWorkspace() const {
    const std::vector<PrintedMarker> markers = {{3, {-0.9, 0.9}, 0.5},
                                                {17, {0.45, -0.4}, 0.5}};
    const PinholeCamera camera{640, 480, 700, 700, 320, 240};
    fs::create_directories(folder_ / "w" / "images");
    SparseModel model;
    model.cameras.push_back(
        {1, camera_model::kPinhole, 640, 480, {700, 700, 320, 240}});
    for (int i = 0; i < kViews; ++i) {
      const double angle = 0.7 * i;
      const Rigid3d cam_from_world =
          LookAtOrigin({2 * std::cos(angle), 2 * std::sin(angle), 2.5});
      SparseImage& image = model.images.emplace_back();
      image.id = uint32_t(i + 1);
      image.camera_id = 1;
      image.name = "view_" + std::to_string(i) + ".png";
      image.rotation = Eigen::Quaterniond(cam_from_world.rotation);
      image.translation = cam_from_world.translation;
      ASSERT_TRUE(cv::imwrite((folder_ / "w" / "images" / image.name).string(),
                              RenderMarkers(markers, camera, cam_from_world)));
    }
    for (int i = 0; i < 100; ++i) {
      SparsePoint& point = model.points.emplace_back();
      const int row = i / 10;
      point.id = uint64_t(i) + 1;
      point.xyz = Eigen::Vector3d(0.2 * (i % 10) - 0.9, 0.2 * row - 0.9, 0);
      point.error = 0.3;
    }
    WriteSparseModelBinary(model, folder_ / "w" / "sparse" / "0");
  }

  TemporaryFolder folder_;
  IndexedMesh mesh_;
};

TEST_F(MeshExporterTest, MillimetresOnThePlate) {
  const ProgramResult result = Export(
      {"--known_length", "60", "--between", "0,0,0,0,0,0.6", "--up", "1,0,0"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("mm"));
  const MeshAudit audit = AuditOf();
  EXPECT_EQ(audit.DescribeFailure(), "");
  EXPECT_NEAR(audit.bounding_box.min().z(), 0, 1e-5);
  EXPECT_NEAR(audit.bounding_box.sizes().z(), 60, 0.5);
  EXPECT_NEAR(audit.bounding_box.center().x(), 0, 1e-4);
  const nlohmann::json report = Report();
  EXPECT_EQ(report["unit"], "millimetre");
  EXPECT_NEAR(report["scale"]["factor"], 100, 1e-9);
  // The matrix leads from the mesh to the file.
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      matrix(row, column) = report["file_from_mesh"][row][column];
    }
  }
  const Eigen::Matrix3d turned_and_scaled = matrix.topLeftCorner<3, 3>();
  EXPECT_NEAR(turned_and_scaled.determinant(), 1e6, 1);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : mesh_.positions) {
    box.extend((matrix * position.homogeneous()).head<3>());
  }
  EXPECT_LT((box.min() - audit.bounding_box.min()).norm(), 1e-4);
  EXPECT_LT((box.max() - audit.bounding_box.max()).norm(), 1e-4);
  EXPECT_GT(matrix(2, 0), 99);  // x points up
}

TEST_F(MeshExporterTest, FlatBase) {
  const ProgramResult result = Export(
      {"--scale_factor", "100", "--flat_base", "1", "--base_depth", "6"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const MeshAudit audit = AuditOf();
  EXPECT_EQ(audit.DescribeFailure(), "");
  EXPECT_NEAR(audit.bounding_box.sizes().z(), 54, 0.5);
  const nlohmann::json report = Report();
  EXPECT_NEAR(
      report["flat_base"]["area"], std::numbers::pi * (60 * 6 - 36), 20);
  EXPECT_EQ(report["flat_base"]["islands"], 1);
  EXPECT_EQ(report["self_intersections"]["pairs"], 0);
}

// The mesh fits into a limit of the size of files, the report does not.
TEST_F(MeshExporterTest, WritesAllFilesOrNone) {
  WriteMesh(folder_ / "cube.ply", Cube(1));
  folder_.Write("out.stl", "precious");
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const ProgramResult result = RunningOctacut({"mesh_exporter",
                                               "--input_path",
                                               Path("cube.ply"),
                                               "--output_path",
                                               Path("out.stl"),
                                               "--scale_factor",
                                               "10"})
                                   .Wait();
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("out.stl.json: cannot be written"));
  EXPECT_EQ(ReadFile(folder_ / "out.stl"), "precious");
  EXPECT_FALSE(fs::exists(folder_ / "out.stl.json"));
}

TEST_F(MeshExporterTest, EveryFormat) {
  for (const char* name :
       {"out.3mf", "out.stl", "out.ply", "out.obj", "out.off"}) {
    const ProgramResult result =
        Export({"--output_path", Path(name), "--scale_factor", "100"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    if (fs::path(name).extension() != ".3mf") {
      EXPECT_NEAR(AuditOf(name).bounding_box.sizes().z(), 60, 0.5);
    }
  }
  EXPECT_EQ(ReadMesh(folder_ / "out.ply").mesh.colors, mesh_.colors);
  // A ZIP archive, the same each time.
  const std::string package = ReadFile(folder_ / "out.3mf");
  EXPECT_EQ(package.substr(0, 2), "PK");
  EXPECT_THAT(package, HasSubstr("3D/3dmodel.model"));
  Export({"--output_path", Path("again.3mf"), "--scale_factor", "100"});
  EXPECT_EQ(ReadFile(folder_ / "again.3mf"), package);
}

TEST_F(MeshExporterTest, ScaleFromMarkersAndUpFromTheStand) {
  MakeWorkspace();
  // Turned over: the stand turns it back.
  const ProgramResult result = Export(
      {"--aruco_side", "25", "--up", "stand", "--workspace_path", Path("w")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json report = Report();
  EXPECT_EQ(report["scale"]["source"], "aruco");
  EXPECT_NEAR(report["scale"]["factor"], 50, 0.1);
  EXPECT_EQ(report["scale"]["markers"].size(), 2u);
  EXPECT_GE(report["scale"]["markers"][0]["views"], 4);
  EXPECT_LT(report["scale"]["reprojection_rms_pixels"], 0.3);
  EXPECT_LT(report["scale"]["side_max"], 0.01);
  EXPECT_NEAR(report["up"][2], 1, 1e-6);
  EXPECT_EQ(report["stand"]["points"], report["stand"]["candidates"]);
  EXPECT_NEAR(AuditOf().bounding_box.sizes().z(), 30, 0.3);
}

TEST_F(MeshExporterTest, MistakesAreNamed) {
  MakeWorkspace();
  folder_.Write("out.stl", "precious");
  const std::string workspace = Path("w");
  struct Case {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::vector<Case> cases = {
      {{"--scale_factor", "2", "--aruco_side", "3"}, "at most one of"},
      {{"--scale_factor", "-2"}, "--scale_factor = -2: "},
      {{"--known_length", "3"}, "--known_length and --between"},
      {{"--between", "0,0,0,1,1,1"}, "--known_length and --between"},
      {{"--known_length", "3", "--between", "0,0,0,1"}, "--between = 0,0,0,1"},
      {{"--known_length", "3", "--between", "1,2,3,1,2,3"}, "two different"},
      {{"--up", "sideways"}, "--up = sideways: "},
      {{"--up", "0,0,0"}, "--up = 0,0,0: "},
      {{"--up", "stand"}, "--workspace_path must be given"},
      {{"--aruco_side", "25"}, "--workspace_path must be given"},
      {{"--base_depth", "1"}, "--base_depth = 1: needs"},
      {{"--workspace_path", workspace},
       "--workspace_path has no effect without --aruco_side"},
      {{"--flat_base", "1", "--base_depth", "9"}, "--base_depth = 9: must be"},
      {{"--output_path", Path("mesh.ply")}, "--output_path = "},
      {{"--output_path", Path("x.glc")}, "unknown mesh extension"},
      {{"--output_path", Path("x.glb")}, "units are metres"},
      {{"--output_path", Path("x.3mf"), "--scale_factor", "1e-9"},
       "x.3mf: 3MF has six decimals"},
      {{"--aruco_side",
        "25",
        "--aruco_dictionary",
        "7x7_250",
        "--workspace_path",
        workspace},
       "images: the photographs show no ArUco marker of this "
       "dictionary"},
  };
  for (const Case& mistake : cases) {
    const ProgramResult result = Export(mistake.arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(mistake.message));
    EXPECT_THAT(result.out, IsEmpty());
  }
  EXPECT_EQ(ReadFile(folder_ / "out.stl"), "precious");
  folder_.Write("far.off",
                "OFF\n4 4 0\n1e7 0 0\n10000000.3 0 0\n1e7 0.3 0\n1e7 0 0.3\n"
                "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  EXPECT_THAT(RunOctacut({"mesh_exporter",
                          "--input_path",
                          Path("far.off"),
                          "--output_path",
                          Path("out.stl")})
                  .err,
              HasSubstr("far.off: in single precision"));
  EXPECT_EQ(ReadFile(folder_ / "out.stl"), "precious");
  fs::remove(folder_ / "w" / "images" / "view_3.png");
  EXPECT_THAT(Export({"--aruco_side", "25", "--workspace_path", workspace}).err,
              HasSubstr("view_3.png"));
}

TEST_F(MeshExporterTest, WarnsWithoutAScale) {
  const ProgramResult result = Export({});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("no scale is given"));
  EXPECT_EQ(Report()["scale"]["source"], "none");
}

}  // namespace
}  // namespace octacut
