#include "core/pipeline/prepare_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/views/mask_shifts.h"
#include "tests/core/base/recorder.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"
#include "tests/core/pipeline/reconstruction_checks.h"

namespace octacut {
namespace {

using ::testing::AllOf;
using ::testing::DoubleNear;
using ::testing::Each;
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

double Difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / 255;
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
  for (size_t i = 0; i < scene.views.size(); ++i) {
    EXPECT_NEAR(prepared.moved_inwards[i], i == 5 ? 6 : 0, i == 5 ? 0.5 : 0);
  }
  EXPECT_THAT(
      recorder.warnings,
      ElementsAre(AllOf(HasSubstr("1 of 24 masks are too large or too small"),
                        HasSubstr(view.name + " (6."))));
  // The moved mask is the right one to some pixels of its outline.
  EXPECT_LT(Difference(prepared.repaired.scene.views[5].mask, given),
            0.15 * Difference(view.mask, given));
}

TEST(PrepareScene, MovesTheBordersOfAllMasksThatAreFarOff) {
  const Scene right = LumpScene();
  for (const double off : {7.5, -7.5}) {
    testing::Recorder recorder;
    const Context context(2, &recorder);
    Scene scene = right;
    for (View& view : scene.views) {
      view.mask =
          MoveBorderInside(Silhouette(view.mask), view.mask.size(), -off);
    }
    const PreparedScene prepared =
        PrepareScene(scene, CubeOf(right), {}, context);
    EXPECT_THAT(prepared.moved_inwards, Each(DoubleNear(off, 0.5)));
    EXPECT_THAT(recorder.warnings,
                ElementsAre(AllOf(HasSubstr("all masks are about"),
                                  HasSubstr(off > 0 ? "large" : "small"))));
    EXPECT_LT(
        Difference(prepared.repaired.scene.views[0].mask, right.views[0].mask),
        0.15 * Difference(scene.views[0].mask, right.views[0].mask));
    // What is left is found as well.
    ASSERT_TRUE(prepared.border_edges);
    EXPECT_NEAR(
        prepared.moved_inwards[0] + prepared.border_edges->shift, off, 0.2);
  }
}

TEST(PrepareScene, LeavesMasksAloneThatAreRightOrMayNotBeMoved) {
  testing::Recorder recorder;
  const Context context(2, &recorder);
  Scene scene = LumpScene();
  const BoundingCube cube = CubeOf(scene);
  EXPECT_THAT(PrepareScene(scene, cube, {}, context).moved_inwards, Each(0));
  GrowByADisc(6, &scene.views[5].mask);
  const PreparedScene kept =
      PrepareScene(scene, cube, {.move_mask_borders = false}, context);
  EXPECT_THAT(kept.moved_inwards, Each(0));
  EXPECT_TRUE(recorder.warnings.empty());
}

}  // namespace
}  // namespace octacut
