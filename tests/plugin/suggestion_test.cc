#include "plugin/suggestion.h"

#include <gtest/gtest.h>

namespace octacut {
namespace {

TEST(EditDistance, CountsSingleCharacterEdits) {
  EXPECT_EQ(EditDistance("", ""), 0u);
  EXPECT_EQ(EditDistance("abc", ""), 3u);
  EXPECT_EQ(EditDistance("", "abc"), 3u);
  EXPECT_EQ(EditDistance("level", "level"), 0u);
  EXPECT_EQ(EditDistance("level", "leve"), 1u);
  EXPECT_EQ(EditDistance("level", "leevel"), 1u);
  EXPECT_EQ(EditDistance("level", "lebel"), 1u);
  EXPECT_EQ(EditDistance("level", "elvel"), 1u);  // neighbours swapped
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3u);
}

TEST(NearestName, FindsTypingMistakesOnly) {
  const std::vector<std::string> names = {
      "mesh_comparer", "OctahedralMeshing.hull_level", "input_path"};
  EXPECT_EQ(NearestName("mesh_compare", names), "mesh_comparer");
  EXPECT_EQ(NearestName("mseh_comparer", names), "mesh_comparer");
  EXPECT_EQ(NearestName("inputpath", names), "input_path");
  EXPECT_EQ(NearestName("hull_level", names), "OctahedralMeshing.hull_level");
  EXPECT_EQ(NearestName("OctahedralMeshing.hul_level", names),
            "OctahedralMeshing.hull_level");
  EXPECT_EQ(NearestName("poisson_mesher", names), "");
  EXPECT_EQ(NearestName("", names), "");
  EXPECT_EQ(NearestName("x", {}), "");
}

}  // namespace
}  // namespace octacut
