#include "core/segment/turntable_views.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/segment/labels.h"
#include "tests/core/base/recorder.h"
#include "tests/core/segment/plate_scene.h"

namespace octacut {
namespace {

using testing::RingScene;

// Returns how many warnings there are.
size_t UseTurntableOf(RingScene* scene,
                      const std::optional<Eigen::AlignedBox3d>& box = {}) {
  std::vector<Pose> poses;
  for (const UnsegmentedView& view : scene->input.views) {
    poses.push_back(view.pose);
  }
  testing::Recorder recorder;
  UseTurntable(
      FindSearchRegion(poses, box), Context(2, &recorder), &scene->input);
  return recorder.warnings.size();
}

// The upper half of the ball looks like the background.
void LoseTop(UnsegmentedView* view) {
  view->labels.rowRange(0, view->labels.rows / 2).setTo(kSurroundingsLabel);
}

TEST(UseTurntable, KnowsWhatIsAboveThePlate) {
  RingScene scene = testing::MakePlateScene(12);
  scene.input.views[3].labels.release();
  scene.input.views[3].is_turntable = false;
  LoseTop(&scene.input.views[7]);  // a single view is not enough
  EXPECT_EQ(UseTurntableOf(&scene), 0u);
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    const UnsegmentedView& view = scene.input.views[i];
    EXPECT_EQ(view.is_turntable, i != 3);
    EXPECT_EQ(view.above_plate.empty(), i == 3);
    if (i != 3 && i != 7) {
      EXPECT_GT(cv::countNonZero(view.above_plate), 200) << i;
    }
  }
}

// Other masks leave nothing of the upper half in the box around the lower one.
TEST(UseTurntable, JudgesMasksByPixelsOfTheBox) {
  RingScene scene = testing::MakePlateScene(12);
  EXPECT_EQ(
      UseTurntableOf(&scene,
                     Eigen::AlignedBox3d(Eigen::Vector3d(-0.45, -0.45, -0.5),
                                         Eigen::Vector3d(0.45, 0.45, 0))),
      0u);
  EXPECT_TRUE(scene.input.views[0].is_turntable);
}

TEST(UseTurntable, DropsMasksThatContradictEachOther) {
  RingScene scene = testing::MakePlateScene(12);
  for (size_t i = 0; i < scene.truth.size(); i += 3) {
    LoseTop(&scene.input.views[i]);
  }
  EXPECT_EQ(UseTurntableOf(&scene), 1u);
  for (const UnsegmentedView& view : scene.input.views) {
    EXPECT_FALSE(view.is_turntable);
    EXPECT_TRUE(view.labels.empty());
    EXPECT_TRUE(view.above_plate.empty());
  }
}

}  // namespace
}  // namespace octacut
