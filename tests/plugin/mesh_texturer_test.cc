// mesh_texturer, and the texture of octahedral_mesher, as a user meets them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_io/files/read_file.h"
#include "colmap_io/mesh/mesh_io.h"
#include "plugin/report.h"
#include "tests/plugin/small_workspace.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class MeshTexturer : public testing::SmallWorkspaceTest {
 protected:
  fs::path Reference() const { return Workspace() / "gt" / "reference.ply"; }
  fs::path Output(const std::string& name) const { return folder_ / name; }

  ProgramResult Texture(const fs::path& output,
                        const std::vector<std::string>& options = {}) const {
    return TextureMesh(Reference(), output, options);
  }

  ProgramResult TextureMesh(
      const fs::path& mesh,
      const fs::path& output,
      const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"mesh_texturer",
                                          "--workspace_path",
                                          Workspace().string(),
                                          "--mesh_path",
                                          mesh.string(),
                                          "--output_path",
                                          output.string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunOctacut(arguments);
  }

  void ExpectError(const std::string& message,
                   const fs::path& mesh,
                   const fs::path& output,
                   const std::vector<std::string>& options = {}) const {
    const ProgramResult result = TextureMesh(mesh, output, options);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_FALSE(fs::exists(output));
  }
};

// The JSON part of a GLB file.
Json JsonOfGlb(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  uint32_t length = 0;
  for (size_t i = 0; i < 4; ++i) {
    length |= uint32_t(uint8_t(bytes[12 + i])) << (8 * i);
  }
  return Json::parse(bytes.substr(20, length));
}

// The Khronos validator, which workflows/setup.sh --with_test_tools 1 installs.
void ValidateGlb(const fs::path& path) {
  const std::string script =
      "const v=require('gltf-validator'),fs=require('fs');"
      "v.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])))"
      ".then(r=>{if(r.issues.numErrors+r.issues.numWarnings){"
      "console.error(JSON.stringify(r.issues));process.exit(1);}})";
  const std::string node = "NODE_PATH=\"$(npm root -g 2>/dev/null)\" node -e ";
  if (std::system(
          (node + "\"require('gltf-validator')\" 2>/dev/null").c_str()) != 0) {
    GTEST_SKIP() << "gltf-validator is not installed: workflows/setup.sh "
                    "--with_test_tools 1";
  }
  EXPECT_EQ(
      std::system(
          (node + "\"" + script + "\" \"" + path.string() + "\"").c_str()),
      0);
}

TEST_F(MeshTexturer, WritesAGlbWithItsPagesInside) {
  const fs::path output = Output("torus.glb");
  const fs::path report = Output("torus.json");
  const ProgramResult result = Texture(output,
                                       {"--report_path",
                                        report.string(),
                                        "--hold_out",
                                        "6",
                                        "--picture_path",
                                        Output("torus.png").string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("torus.glb: "), HasSubstr("charts")));
  const Json json = JsonOfGlb(ReadFile(output));
  EXPECT_EQ(json["images"].size(), 1u);
  EXPECT_EQ(json["images"][0]["mimeType"], "image/png");
  const Json primitive = json["meshes"][0]["primitives"][0];
  EXPECT_EQ(primitive["material"], 0);
  const size_t triangles = ReadMesh(Reference()).mesh.triangles.size();
  EXPECT_EQ(json["accessors"][primitive["indices"].get<size_t>()]["count"],
            3 * triangles);
  const Json texture = Json::parse(ReadFile(report))["texture"];
  EXPECT_EQ(texture["unfilled_texels"], 0);
  EXPECT_LT(texture["seams"]["mean_jump_after"].get<double>(),
            0.6 * texture["seams"]["mean_jump_before"].get<double>());
  EXPECT_EQ(texture["held_out"]["views"], 2);
  EXPECT_GT(texture["held_out"]["meshes"][0]["psnr"].get<double>(), 25);
  EXPECT_FALSE(cv::imread(Output("torus.png").string()).empty());
  ValidateGlb(output);
}

TEST_F(MeshTexturer, WritesObjWithMaterialsAndPlyWithTexcoords) {
  ASSERT_EQ(Texture(Output("t.obj"), {"--image_format", "jpeg"}).exit_code, 0);
  EXPECT_THAT(ReadFile(Output("t.mtl")), HasSubstr("map_Kd t_texture.jpg"));
  const cv::Mat page = cv::imread(Output("t_texture.jpg").string());
  ASSERT_FALSE(page.empty());
  EXPECT_THAT(ReadFile(Output("t.obj")),
              AllOf(HasSubstr("mtllib t.mtl"),
                    HasSubstr("usemtl page_0"),
                    HasSubstr("\nvt ")));
  ASSERT_EQ(Texture(Output("t.ply"), {"--texture_size", "128"}).exit_code, 0);
  EXPECT_THAT(ReadFile(Output("t.ply")),
              AllOf(HasSubstr("comment TextureFile t_texture_0.png"),
                    HasSubstr("property list uchar float texcoord"),
                    HasSubstr("property int texnumber")));
  EXPECT_FALSE(cv::imread(Output("t_texture_0.png").string()).empty());
  // Our own reader skips what it does not use.
  const IndexedMesh mesh = ReadMesh(Reference()).mesh;
  EXPECT_EQ(ReadMesh(Output("t.ply")).mesh.triangles, mesh.triangles);
  EXPECT_EQ(ReadMesh(Output("t.obj")).mesh.triangles.size(),
            mesh.triangles.size());
}

TEST_F(MeshTexturer, ReplacesNoneOfItsOtherFiles) {
  const std::string mesh = Output("m.obj").string();
  WriteMesh(mesh, ReadMesh(Reference()).mesh);
  WriteMesh(Output("full.obj"), ReadMesh(Reference()).mesh);
  const std::string before = ReadFile(mesh);
  const auto expect_refusal = [&](const std::string& message,
                                  const fs::path& output,
                                  const std::vector<std::string>& options) {
    const ProgramResult result = TextureMesh(mesh, output, options);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_EQ(ReadFile(mesh), before);
  };
  expect_refusal("--output_path = " + mesh +
                     ": must not be the same file as the mesh to texture",
                 mesh,
                 {});
  expect_refusal(
      "--report_path = " + mesh, Output("t.glb"), {"--report_path", mesh});
  expect_refusal("must not be the same file as the textured mesh",
                 Output("t.glb"),
                 {"--report_path", Output("t.glb").string()});
  expect_refusal("must not be the same file as a file of the textured mesh",
                 Output("t.obj"),
                 {"--picture_path", Output("t_texture.png").string()});
  expect_refusal("must not be the same file as the mesh of normal_map_from",
                 Output("full.obj"),
                 {"--normal_map_from", Output("full.obj").string()});
  expect_refusal("--picture_path = " + Output("t.xyz").string() +
                     ": must end with .png or .jpg",
                 Output("t.glb"),
                 {"--picture_path", Output("t.xyz").string()});
  EXPECT_FALSE(fs::exists(Output("t.glb")));
}

TEST_F(MeshTexturer, GlbWithPagesOfJpegIsValid) {
  const fs::path output = Output("pages.glb");
  ASSERT_EQ(Texture(output, {"--image_format", "jpeg", "--texture_size", "128"})
                .exit_code,
            0);
  const Json json = JsonOfGlb(ReadFile(output));
  EXPECT_GT(json["images"].size(), 1u);
  EXPECT_EQ(json["images"][0]["mimeType"], "image/jpeg");
  ValidateGlb(output);
}

TEST_F(MeshTexturer, FilesAreTheSameForAnyNumberOfThreads) {
  for (const char* blending : {"best", "median"}) {
    for (const char* threads : {"1", "2"}) {
      ASSERT_EQ(Texture(Output(std::string(threads) + ".glb"),
                        {"--view_blending", blending, "--num_threads", threads})
                    .exit_code,
                0);
    }
    EXPECT_EQ(ReadFile(Output("1.glb")), ReadFile(Output("2.glb")));
  }
}

TEST_F(MeshTexturer, WarnsOfMeshesThatAreHardlySeen) {
  IndexedMesh mesh = ReadMesh(Reference()).mesh;
  for (Eigen::Vector3d& position : mesh.positions) {
    position *= 20;
  }
  WriteMesh(Output("scaled.ply"), mesh);
  const ProgramResult result =
      TextureMesh(Output("scaled.ply"), Output("scaled.glb"));
  EXPECT_THAT(result.err, HasSubstr("scaled.ply: the photographs show only"));
}

TEST_F(MeshTexturer, TheMesherTexturesItsOwnMesh) {
  const fs::path mesh = Output("own.ply");
  const ProgramResult result = RunOctacut({"octahedral_mesher",
                                           "--workspace_path",
                                           Workspace().string(),
                                           "--OctahedralMeshing.hull_level",
                                           "5",
                                           "--OctahedralMeshing.target_level",
                                           "6",
                                           "--texture",
                                           "1",
                                           "--output_path",
                                           mesh.string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = JsonOfGlb(ReadFile(Output("own.glb")));
  const Json primitive = json["meshes"][0]["primitives"][0];
  EXPECT_EQ(json["accessors"][primitive["indices"].get<size_t>()]["count"],
            3 * ReadMesh(mesh).mesh.triangles.size());
  EXPECT_EQ(json["images"].size(), 1u);
  const Json texture = Json::parse(ReadFile(Output("own.json")))["texture"];
  EXPECT_EQ(texture["unfilled_texels"], 0);
  EXPECT_LT(texture["unseen_area_fraction"].get<double>(), 0.2);
}

TEST_F(MeshTexturer, NeedsNoMasksAndTakesOpenMeshes) {
  fs::remove_all(Workspace() / "masks");
  IndexedMesh open = ReadMesh(Reference()).mesh;
  open.triangles.resize(open.triangles.size() / 2);
  WriteMesh(Output("open.ply"), open);
  const ProgramResult result =
      TextureMesh(Output("open.ply"), Output("open.glb"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(fs::exists(Output("open.glb")));
}

TEST_F(MeshTexturer, WritesANormalMapOfTheFullMesh) {
  const fs::path output = Output("bumps.glb");
  const fs::path report = Output("bumps.json");
  const ProgramResult result = Texture(output,
                                       {"--normal_map_from",
                                        Reference().string(),
                                        "--report_path",
                                        report.string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = JsonOfGlb(ReadFile(output));
  EXPECT_EQ(json["images"].size(), 2u);
  EXPECT_TRUE(json["materials"][0].contains("normalTexture"));
  EXPECT_TRUE(
      json["meshes"][0]["primitives"][0]["attributes"].contains("TANGENT"));
  const Json map = Json::parse(ReadFile(report))["texture"]["normal_map"];
  EXPECT_EQ(map["missed_texels"], 0);
  // The mesh is the full one.
  EXPECT_LT(map["mean_angle_degrees"].get<double>(), 0.5);
  ValidateGlb(output);
}

TEST_F(MeshTexturer, RefusesFullMeshesThatDoNotFit) {
  const fs::path output = Output("refused.glb");
  IndexedMesh mesh = ReadMesh(Reference()).mesh;
  for (Eigen::Vector3d& position : mesh.positions) {
    position *= 1.5;
  }
  WriteMesh(Output("scaled.ply"), mesh);
  ExpectError("scaled.ply: the mesh for the normal map is further than",
              Reference(),
              output,
              {"--normal_map_from", Output("scaled.ply").string()});
  ExpectError("none.ply",
              Reference(),
              output,
              {"--normal_map_from", Output("none.ply").string()});
  ExpectError("needs an output_path that ends with .glb or .obj",
              Reference(),
              Output("refused.ply"),
              {"--normal_map_from", Reference().string()});
}

TEST_F(MeshTexturer, RefusesWrongInputWithOneError) {
  const fs::path output = Output("refused.glb");
  ExpectError("--max_pages = 1: the texture needs",
              Reference(),
              output,
              {"--texture_size", "64", "--max_pages", "1"});
  ExpectError("unknown extension \".stl\" of a textured mesh",
              Reference(),
              Output("x.stl"));
  IndexedMesh mesh = ReadMesh(Reference()).mesh;
  for (Eigen::Vector3d& position : mesh.positions) {
    position += Eigen::Vector3d(0, 500, 0);
  }
  WriteMesh(Output("moved.ply"), mesh);
  ExpectError("frame of the sparse model", Output("moved.ply"), output);
  IndexedMesh inward = ReadMesh(Reference()).mesh;
  for (auto& triangle : inward.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  WriteMesh(Output("inward.ply"), inward);
  ExpectError("inward.ply: none of the 12 photographs shows a triangle",
              Output("inward.ply"),
              output);
  mesh.triangles.clear();
  WriteMesh(Output("points.ply"), mesh);
  ExpectError(
      "points.ply: the mesh has no faces", Output("points.ply"), output);
  fs::remove_all(Workspace() / "images");
  fs::create_directory(Workspace() / "images");
  ExpectError(
      "no such image; missing for 12 of 12 images", Reference(), output);
}

}  // namespace
}  // namespace octacut
