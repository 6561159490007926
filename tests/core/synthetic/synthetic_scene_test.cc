#include "core/synthetic/synthetic_scene.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/base/error.h"

namespace octacut {
namespace {

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && a.isContinuous() &&
         b.isContinuous() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

TEST(MakeScene, GivesTheSameBytesForAnyNumberOfThreads) {
  SceneSpec spec = QuickScene("torus", 80, 60, 3);
  spec.reference.resolution = 40;
  spec.degrade.pixel_noise = 2;
  spec.degrade.pose_noise = 0.5;
  const SyntheticScene one = MakeScene(spec, Context(1));
  for (const int num_threads : {2, 4}) {
    const SyntheticScene many = MakeScene(spec, Context(num_threads));
    EXPECT_EQ(one.reference.positions, many.reference.positions);
    EXPECT_EQ(one.reference.triangles, many.reference.triangles);
    ASSERT_EQ(one.views.size(), many.views.size());
    for (size_t i = 0; i < one.views.size(); ++i) {
      EXPECT_TRUE(SameBytes(one.views[i].image, many.views[i].image));
      EXPECT_TRUE(SameBytes(one.views[i].mask, many.views[i].mask));
      EXPECT_EQ(one.views[i].cam_from_world.rotation,
                many.views[i].cam_from_world.rotation);
    }
    EXPECT_EQ(one.points.size(), many.points.size());
  }
}

}  // namespace
}  // namespace octacut
