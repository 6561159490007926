#include "plugin/quality.h"

#include <gtest/gtest.h>

namespace octacut {
namespace {

struct Applied {
  ReconstructionOptions meshing;
  std::string message;
};

Applied Apply(const std::vector<std::string>& arguments) {
  Applied applied;
  OptionManager options;
  QualityOption quality;
  quality.Declare(options);
  options.Add("OctahedralMeshing.target_level",
              &applied.meshing.target_level,
              "Level.");
  options.Add("OctahedralMeshing.refine", &applied.meshing.refine, "Refine.");
  options.Parse(arguments);
  applied.message = quality.Apply(options, &applied.meshing);
  return applied;
}

TEST(QualityOption, ChoosesLevelAndRefinement) {
  const auto expect = [](const std::string& quality, int level, bool refine) {
    const Applied applied = Apply({"--quality", quality});
    EXPECT_EQ(applied.meshing.target_level, level) << quality;
    EXPECT_EQ(applied.meshing.refine, refine) << quality;
  };
  expect("low", 8, false);
  expect("medium", 9, false);
  expect("high", 9, true);
  expect("extreme", 10, true);
}

TEST(QualityOption, HighIsTheDefault) {
  const Applied applied = Apply({});
  const ReconstructionOptions defaults;
  EXPECT_EQ(applied.meshing.target_level, defaults.target_level);
  EXPECT_EQ(applied.meshing.refine, defaults.refine);
  EXPECT_EQ(applied.message,
            "Quality high: 512^3 voxels (level 9), with refinement.");
}

TEST(QualityOption, GivenOptionsWin) {
  const Applied level =
      Apply({"--quality", "extreme", "--OctahedralMeshing.target_level", "8"});
  EXPECT_EQ(level.meshing.target_level, 8);
  EXPECT_TRUE(level.meshing.refine);
  EXPECT_EQ(level.message,
            "Quality extreme with the given --OctahedralMeshing.target_level: "
            "256^3 voxels (level 8), with refinement.");
  const Applied both = Apply({"--quality=low",
                              "--OctahedralMeshing.refine=1",
                              "--OctahedralMeshing.target_level=9"});
  EXPECT_EQ(both.meshing.target_level, 9);
  EXPECT_TRUE(both.meshing.refine);
  EXPECT_EQ(both.message,
            "Quality low with the given --OctahedralMeshing.target_level and "
            "--OctahedralMeshing.refine: 512^3 voxels (level 9), with "
            "refinement.");
}

TEST(QualityOption, RefusesOtherWords) {
  EXPECT_THROW(Apply({"--quality", "best"}), OptionError);
}

}  // namespace
}  // namespace octacut
