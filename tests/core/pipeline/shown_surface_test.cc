#include "core/pipeline/shown_surface.h"

#include <gtest/gtest.h>

#include <string>

#include "core/benchmark/synthetic/material.h"
#include "core/hull/hull_surface.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

ShownSurface Shown(const std::string& object, MaterialKind material) {
  SceneSpec spec = testing::TestSpec(object, 160, 120, 20);
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
    EXPECT_EQ(Shown("lump", material).share, 1) << int(material);
  }
  const ShownSurface metal = Shown("lump", MaterialKind::kMetal);
  EXPECT_EQ(metal.share, 0);
  EXPECT_LT(metal.agreement, 0.3);
}

}  // namespace
}  // namespace octacut
