#include "core/pipeline/shown_surface.h"

#include <gtest/gtest.h>

#include "core/benchmark/synthetic/material.h"
#include "core/hull/hull_surface.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

ShownSurface ShownOfLump(MaterialKind material) {
  SceneSpec spec = testing::TestSpec("lump", 160, 120, 20);
  spec.material = material;
  const testing::TestScene test = testing::MakeTestScene(spec);
  const LabeledVoxels hull = ComputeHullSurface(
      test.views, testing::TestScene::UnitBox(), {.hull_level = 6}, Context(2));
  return MeasureShownSurface(test.views, hull, RefineOptions(), Context(2));
}

TEST(MeasureShownSurface, TellsMirrorsFromMattAndGlazedObjects) {
  for (const MaterialKind material : {MaterialKind::kDiffuse,
                                      MaterialKind::kPlaster,
                                      MaterialKind::kPorcelain}) {
    EXPECT_EQ(ShownOfLump(material).share, 1) << int(material);
  }
  const ShownSurface metal = ShownOfLump(MaterialKind::kMetal);
  EXPECT_EQ(metal.share, 0);
  EXPECT_LT(metal.agreement, 0.3);
}

}  // namespace
}  // namespace octacut
