#include "tests/architecture/source_rules.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(SourceRules, TheTreeKeepsThem) {
  const fs::path root = OCTACUT_SOURCE_DIR;
  EXPECT_GT(CountSourceFiles(root), 50u);
  EXPECT_THAT(FindRuleViolations(root), IsEmpty());
}

// A small tree of its own that keeps the rules until a test plants a file.
class PlantedTree : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* const test =
        ::testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::temp_directory_path() /
            fmt::format("octacut_{}_{}", test->name(), getpid());
    for (const char* header : {"core/base/error.h",
                               "core/scene/scene.h",
                               "core/grid/morton.h",
                               "core/cut/cut.h",
                               "core/mesh/mesh.h",
                               "core/pipeline/pipeline.h",
                               "core/benchmark/compare/compare.h",
                               "core/benchmark/synthetic/shape.h",
                               "colmap_io/model/model.h",
                               "plugin/command.h"}) {
      Plant(header, "#pragma once\n");
    }
    std::string folders;
    for (const char* folder : {"base",
                               "scene",
                               "grid",
                               "cut",
                               "mesh",
                               "raycast",
                               "refine",
                               "visibility",
                               "pipeline",
                               "benchmark"}) {
      folders += fmt::format("add_subdirectory({})\n", folder);
    }
    Plant("core/CMakeLists.txt", folders);
    ASSERT_THAT(FindRuleViolations(root_), IsEmpty());
  }
  void TearDown() override { fs::remove_all(root_); }

  void Plant(const fs::path& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  // The violations of a file with one include in its second line.
  std::vector<std::string> WithInclude(const fs::path& path,
                                       const std::string& include) {
    Plant(path, fmt::format("// A file.\n#include {}\n", include));
    std::vector<std::string> violations = FindRuleViolations(root_);
    fs::remove(root_ / path);
    return violations;
  }

  fs::path root_;
};

TEST_F(PlantedTree, LayersPointDown) {
  EXPECT_THAT(WithInclude("colmap_io/model/x.cc", "\"core/base/error.h\""),
              IsEmpty());
  EXPECT_THAT(WithInclude("plugin/x.cc", "\"colmap_io/model/model.h\""),
              IsEmpty());
  EXPECT_THAT(WithInclude("plugin/x.cc", "\"core/pipeline/pipeline.h\""),
              IsEmpty());
  EXPECT_THAT(WithInclude("tests/plugin/x.cc", "\"plugin/command.h\""),
              IsEmpty());
  EXPECT_THAT(
      WithInclude("core/pipeline/x.cc", "\"colmap_io/model/model.h\""),
      ElementsAre("core/pipeline/x.cc:2: core must not include colmap_io"));
  EXPECT_THAT(WithInclude("core/base/x.cc", "\"plugin/command.h\""),
              ElementsAre(HasSubstr("core must not include plugin")));
  EXPECT_THAT(WithInclude("colmap_io/model/x.cc", "\"plugin/command.h\""),
              ElementsAre(HasSubstr("colmap_io must not include plugin")));
  // The other quotes are no way around.
  EXPECT_THAT(WithInclude("core/base/x.cc", "<plugin/command.h>"),
              ElementsAre(HasSubstr("core must not include plugin")));
}

TEST_F(PlantedTree, CoreFollowsTheDataFlow) {
  EXPECT_THAT(WithInclude("core/grid/x.h", "\"core/grid/morton.h\""),
              ElementsAre("core/grid/x.h:1: no #pragma once"));
  EXPECT_THAT(WithInclude("core/grid/x.cc", "\"core/grid/morton.h\""),
              IsEmpty());
  EXPECT_THAT(WithInclude("core/pipeline/x.cc", "\"core/cut/cut.h\""),
              IsEmpty());
  EXPECT_THAT(WithInclude("core/grid/x.cc", "\"core/cut/cut.h\""),
              ElementsAre(HasSubstr("core/grid must not include core/cut")));
  EXPECT_THAT(WithInclude("core/base/x.cc", "\"core/scene/scene.h\""),
              ElementsAre(HasSubstr("core/base must not include core/scene")));
  EXPECT_THAT(WithInclude("core/novelty/x.cc", "\"core/base/error.h\""),
              ElementsAre(HasSubstr("core/novelty has no place")));
}

TEST_F(PlantedTree, CompareAndSyntheticStandBeside) {
  EXPECT_THAT(
      WithInclude("core/benchmark/compare/x.cc", "\"core/mesh/mesh.h\""),
      IsEmpty());
  EXPECT_THAT(
      WithInclude("core/benchmark/synthetic/x.cc", "\"core/scene/scene.h\""),
      IsEmpty());
  EXPECT_THAT(WithInclude("core/benchmark/compare/x.cc", "\"core/cut/cut.h\""),
              ElementsAre(HasSubstr("must not include core/cut")));
  EXPECT_THAT(
      WithInclude("core/benchmark/compare/x.cc",
                  "\"core/benchmark/synthetic/shape.h\""),
      ElementsAre(HasSubstr("must not include core/benchmark/synthetic")));
  EXPECT_THAT(
      WithInclude("core/pipeline/x.cc", "\"core/benchmark/compare/compare.h\""),
      ElementsAre(HasSubstr("must not include core/benchmark/compare")));
}

TEST_F(PlantedTree, CoreNamesNoOptions) {
  const auto with_text = [&](const fs::path& path) {
    Plant(path, "const char* text = \"use --input_path\";\n");
    std::vector<std::string> violations = FindRuleViolations(root_);
    fs::remove(root_ / path);
    return violations;
  };
  EXPECT_THAT(with_text("core/grid/x.cc"),
              ElementsAre(HasSubstr("core/grid/x.cc:1: core must not name")));
  EXPECT_THAT(with_text("plugin/x.cc"), IsEmpty());
}

TEST_F(PlantedTree, CoreKnowsNoFiles) {
  for (const char* header : {"<fstream>",
                             "<filesystem>",
                             "<opencv2/imgcodecs.hpp>",
                             "<opencv2/highgui.hpp>",
                             "<opencv2/opencv.hpp>"}) {
    EXPECT_THAT(WithInclude("core/mesh/x.cc", header),
                ElementsAre(HasSubstr("core must not include")));
    EXPECT_THAT(WithInclude("colmap_io/model/x.cc", header), IsEmpty());
  }
}

TEST_F(PlantedTree, LibrariesStayInTheirFolders) {
  const std::string open_mesh = "<OpenMesh/Core/Mesh/Traits.hh>";
  EXPECT_THAT(WithInclude("core/mesh/x.cc", open_mesh), IsEmpty());
  EXPECT_THAT(WithInclude("core/refine/x.cc", open_mesh), IsEmpty());
  EXPECT_THAT(WithInclude("core/pipeline/x.cc", open_mesh),
              ElementsAre(HasSubstr("belongs into core/mesh/")));
  EXPECT_THAT(WithInclude("colmap_io/mesh/x.cc", open_mesh),
              ElementsAre(HasSubstr("belongs into core/mesh/")));
  EXPECT_THAT(WithInclude("core/mesh/x.cc", "<ceres/ceres.h>"),
              ElementsAre(HasSubstr("belongs into core/refine/")));
  EXPECT_THAT(WithInclude("core/raycast/x.cc", "<embree3/rtcore.h>"),
              IsEmpty());
  EXPECT_THAT(WithInclude("core/visibility/x.cc", "<embree3/rtcore.h>"),
              ElementsAre(HasSubstr("belongs into core/raycast/")));
}

TEST_F(PlantedTree, QuotedIncludesArePathsFromTheTop) {
  EXPECT_THAT(WithInclude("core/grid/x.cc", "\"morton.h\""),
              ElementsAre(HasSubstr("no path from the top")));
  EXPECT_THAT(WithInclude("core/grid/x.cc", "\"core/grid/gone.h\""),
              ElementsAre(HasSubstr("no path from the top")));
}

TEST_F(PlantedTree, TypesHaveNamesOfTheirOwn) {
  Plant("core/grid/a.h", "#pragma once\nclass Point;\nstruct Plane {\n};\n");
  Plant("core/mesh/b.h", "#pragma once\nclass Point {\n};\n");
  EXPECT_THAT(FindRuleViolations(root_), IsEmpty());
  Plant("plugin/c.h", "#pragma once\nclass Plane final : public Point {\n};\n");
  EXPECT_THAT(FindRuleViolations(root_),
              ElementsAre(HasSubstr(
                  "plugin/c.h:2: core/grid/a.h also defines a type Plane")));
}

TEST_F(PlantedTree, FilesStayShort) {
  std::string text;
  for (size_t i = 0; i < kMaxFileLines; ++i) {
    text += "//\n";
  }
  Plant("core/base/long.cc", text);
  EXPECT_THAT(FindRuleViolations(root_), IsEmpty());
  Plant("core/base/long.cc", text + "//\n");
  EXPECT_THAT(FindRuleViolations(root_),
              ElementsAre(HasSubstr("core/base/long.cc:451: longer than")));
}

}  // namespace
}  // namespace octacut
