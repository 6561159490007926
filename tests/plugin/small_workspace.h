// A workspace of twelve small views of a torus, made by the executable under
// test, and what a run of octacut on it is to leave alone.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/plugin/run_octacut.h"

namespace octacut::testing {

inline constexpr int kSmallViews = 12;
inline constexpr int kSmallWidth = 180;
inline constexpr int kSmallHeight = 135;

// Each test gets a copy, W, that it may spoil.
class SmallWorkspaceTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    original_ = new TemporaryFolder;
    const ProgramResult example = RunOctacut({"example_creator",
                                              "--output_path",
                                              (*original_ / "w").string(),
                                              "--scene",
                                              "torus",
                                              "--num_views",
                                              std::to_string(kSmallViews),
                                              "--width",
                                              std::to_string(kSmallWidth),
                                              "--height",
                                              std::to_string(kSmallHeight),
                                              "--num_points",
                                              "500",
                                              "--reference_resolution",
                                              "40"});
    ASSERT_EQ(example.exit_code, 0) << example.err;
  }
  static void TearDownTestSuite() {
    delete original_;
    original_ = nullptr;
  }

  SmallWorkspaceTest() {
    std::filesystem::copy(*original_ / "w",
                          Workspace(),
                          std::filesystem::copy_options::recursive);
  }

  std::filesystem::path Workspace() const { return folder_ / "w"; }
  std::filesystem::path Image(int view) const {
    return Workspace() / "images" / ViewName(view);
  }
  std::filesystem::path Mask(int view) const {
    return Workspace() / "masks" / (ViewName(view) + ".png");
  }
  std::filesystem::path Model(const std::string& file) const {
    return Workspace() / "sparse" / "0" / file;
  }

  // 32^3 to 64^3: two seconds.
  ProgramResult RunMesher(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"octahedral_mesher",
                                          "--workspace_path",
                                          Workspace().string(),
                                          "--OctahedralMeshing.hull_level",
                                          "5",
                                          "--OctahedralMeshing.target_level",
                                          "6"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunOctacut(arguments);
  }

  // The same without refinement and picture.
  ProgramResult RunCut(std::vector<std::string> options = {}) const {
    options.insert(options.begin(),
                   {"--picture", "0", "--OctahedralMeshing.refine", "0"});
    return RunMesher(options);
  }

  TemporaryFolder folder_;

 private:
  static std::string ViewName(int view) {
    return (view < 10 ? "view_00" : "view_0") + std::to_string(view) + ".jpg";
  }

  static inline TemporaryFolder* original_ = nullptr;
};

}  // namespace octacut::testing
