#include "core/views/view_set.h"

#include <gtest/gtest.h>

#include "tests/core/views/random_views.h"

namespace octacut {
namespace {

// A view along the z axis, so far from the point (0.5, 0.5, 0.5).
PreparedView ViewFrom(double distance, double focal_length) {
  View view;
  view.camera = {640, 480, focal_length, focal_length, 320, 240};
  view.cam_from_world =
      LookAt({0.5, 0.5, 0.5 - distance}, {0.5, 0.5, 0.5}, {0, 1, 0});
  PreparedView prepared;
  prepared.projection = MakeViewProjection(view, {Eigen::Vector3d::Zero(), 1});
  return prepared;
}

TEST(PixelSize, IsThatOfTheFinestViews) {
  const Eigen::Vector3f point = Eigen::Vector3f::Constant(0.5f);
  EXPECT_NEAR(PixelSize({ViewFrom(2, 400)}, point), 1.0 / 200, 1e-7);
  // A distant view takes no detail from a close one.
  EXPECT_NEAR(PixelSize({ViewFrom(2, 400), ViewFrom(100, 400)}, point),
              (200.0 + 4) / (200 * 200 + 4 * 4),
              1e-7);
}

TEST(PixelSize, LeavesOutViewsThatLookAway) {
  const Eigen::Vector3f point(0.5f, 0.5f, -3);
  EXPECT_EQ(PixelSize({}, point), 0);
  EXPECT_EQ(PixelSize({ViewFrom(2, 400)}, point), 0);
  EXPECT_NEAR(PixelSize({ViewFrom(2, 400), ViewFrom(5.5, 400)}, point),
              1.0 / 200,
              1e-7);
}

}  // namespace
}  // namespace octacut
