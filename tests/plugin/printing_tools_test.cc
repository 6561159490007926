// What programs of others make of exported meshes. Without a program, its tests
// are skipped; workflows/setup.sh --with_test_tools 1 installs them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>

#include "colmap_io/files/read_file.h"
#include "colmap_io/mesh/mesh_io.h"
#include "tests/core/mesh/test_shapes.h"
#include "tests/plugin/other_programs.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;

class PrintingTools : public ::testing::Test {
 protected:
  // A coloured object with a flat base, 60 mm high before it was cut.
  std::string Export(const std::string& name) const {
    IndexedMesh mesh = Moved(Potato(16), {0.3, 0.2, 0.1});
    for (const Eigen::Vector3d& p : mesh.positions) {
      mesh.colors.push_back({uint8_t(128 + 60 * p.x()), 100, 30});
    }
    WriteMesh(folder_ / "mesh.ply", mesh);
    const ProgramResult result = RunOctacut({"mesh_exporter",
                                             "--input_path",
                                             (folder_ / "mesh.ply").string(),
                                             "--output_path",
                                             (folder_ / name).string(),
                                             "--scale_factor",
                                             "20",
                                             "--flat_base",
                                             "1"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    num_triangles_ = std::stoul(result.out.substr(result.out.find(": ") + 2));
    return (folder_ / name).string();
  }

  std::string Run(const std::string& command) const {
    return RunOther(command, folder_);
  }

  TemporaryFolder folder_;
  mutable size_t num_triangles_ = 0;
};

TEST_F(PrintingTools, PrusaSlicerReadsAManifold) {
  SKIP_WITHOUT("prusa-slicer");
  for (const char* name : {"out.3mf", "out.stl", "out.obj"}) {
    const std::string path = Export(name);
    const std::string info = Run(fmt::format("prusa-slicer --info '{}'", path));
    EXPECT_THAT(info, HasSubstr("manifold = yes"));
    EXPECT_THAT(
        info, HasSubstr(fmt::format("number_of_facets = {}", num_triangles_)));
    // Millimetres arrive as such.
    std::smatch match;
    ASSERT_TRUE(
        std::regex_search(info, match, std::regex("max_z = ([0-9.]+)")));
    const nlohmann::json report =
        nlohmann::json::parse(ReadFile(path + ".json"));
    EXPECT_NEAR(std::stod(match[1]),
                report["audit"]["bounding_box"][1][2].get<double>(),
                1e-4);
  }
}

TEST_F(PrintingTools, AdmeshFindsNothingToRepair) {
  SKIP_WITHOUT("admesh");
  const std::string status = Run(fmt::format("admesh '{}'", Export("out.stl")));
  EXPECT_TRUE(std::regex_search(
      status, std::regex("Total disconnected facets +: +0 +0\n")))
      << status;
  for (const char* line : {"Degenerate facets",
                           "Edges fixed",
                           "Facets removed",
                           "Facets added",
                           "Facets reversed",
                           "Backwards edges"}) {
    EXPECT_TRUE(
        std::regex_search(status, std::regex(fmt::format("{} +: +0\n", line))))
        << status;
  }
  EXPECT_TRUE(std::regex_search(status, std::regex("Number of parts +: +1 ")))
      << status;
}

TEST_F(PrintingTools, BlenderOpensObj) {
  SKIP_WITHOUT("blender");
  const std::string path = Export("out.obj");
  const std::string script = folder_.Write(
      "open.py",
      fmt::format("import bpy\n"
                  "bpy.ops.wm.read_factory_settings(use_empty=True)\n"
                  "bpy.ops.import_scene.obj(filepath='{}')\n"
                  "for o in bpy.context.scene.objects:\n"
                  "  print('OPENED', len(o.data.polygons))\n",
                  path));
  EXPECT_THAT(
      Run(fmt::format("blender --background --factory-startup --python '{}'",
                      script)),
      HasSubstr(fmt::format("OPENED {}\n", num_triangles_)));
}

}  // namespace
}  // namespace octacut
