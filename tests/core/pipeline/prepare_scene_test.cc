#include "core/pipeline/prepare_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "tests/core/base/recorder.h"
#include "tests/core/pipeline/reconstruction_checks.h"

namespace octacut {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::PipelineSpec;

Scene LumpScene() {
  return ToScene(MakeScene(PipelineSpec("lump", 320, 240), Context(2)));
}

BoundingCube CubeOf(const Scene& scene) {
  return EstimateRegion(scene.views, scene.points, RegionOptions(), Context(2))
      .cube;
}

void GrowByADisc(int radius, cv::Mat* mask) {
  const cv::Size size(2 * radius + 1, 2 * radius + 1);
  cv::dilate(*mask, *mask, cv::getStructuringElement(cv::MORPH_ELLIPSE, size));
}

TEST(PrepareScene, MovesTheBorderOfAMaskThatIsOff) {
  testing::Recorder recorder;
  const Context context(2, &recorder);
  Scene scene = LumpScene();
  View& view = scene.views[5];
  const cv::Mat given = view.mask.clone();
  GrowByADisc(6, &view.mask);
  const PreparedScene prepared =
      PrepareScene(scene, CubeOf(scene), {}, context);
  ASSERT_EQ(prepared.repaired.shifts.size(), 1u);
  EXPECT_EQ(prepared.repaired.shifts[0].view, 5u);
  EXPECT_NEAR(prepared.repaired.shifts[0].pixels, 6, 0.5);
  EXPECT_THAT(
      recorder.warnings,
      ElementsAre(AllOf(HasSubstr("1 of 24 masks are too large or too small"),
                        HasSubstr(view.name + " (6."))));
  // The moved mask is the right one to some pixels of its outline.
  const cv::Mat& moved = prepared.repaired.scene.views[5].mask;
  const double wrong = cv::norm(moved, given, cv::NORM_L1) / 255;
  const double grown = cv::norm(view.mask, given, cv::NORM_L1) / 255;
  EXPECT_LT(wrong, 0.15 * grown);
}

TEST(PrepareScene, LeavesMasksAloneThatAreRightOrMayNotBeMoved) {
  testing::Recorder recorder;
  const Context context(2, &recorder);
  Scene scene = LumpScene();
  const BoundingCube cube = CubeOf(scene);
  EXPECT_TRUE(PrepareScene(scene, cube, {}, context).repaired.shifts.empty());
  GrowByADisc(6, &scene.views[5].mask);
  const PreparedScene kept =
      PrepareScene(scene, cube, {.move_mask_borders = false}, context);
  EXPECT_TRUE(kept.repaired.shifts.empty());
  EXPECT_TRUE(recorder.warnings.empty());
}

}  // namespace
}  // namespace octacut
