#include "core/scene/surface_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/scene/synthetic_views.h"

namespace octacut {
namespace {

using testing::RenderView;
using testing::Sphere;

std::vector<View> ViewsOfASphere(const Eigen::Vector3d& middle,
                                 double radius,
                                 double distance) {
  std::vector<View> views;
  for (const Eigen::Vector3d& from : {Eigen::Vector3d(1, 0, 0),
                                      Eigen::Vector3d(0, 1, 0),
                                      Eigen::Vector3d(0, 0, 1)}) {
    views.push_back(RenderView(
        middle + distance * from, middle, 400, Sphere(middle, radius)));
  }
  return views;
}

TEST(EstimateSurfaceArea, IsThatOfASphere) {
  const Eigen::Vector3d middle(3, -1, 2);
  const double radius = 0.5;
  const double distance = 2.5;
  std::vector<View> views = ViewsOfASphere(middle, radius, distance);
  const double edge = 1.25;
  const BoundingCube cube{middle - Eigen::Vector3d::Constant(edge / 2), edge};
  // The outline is seen in front of the middle, where it looks larger.
  const double looks_larger = 1 / (1 - std::pow(radius / distance, 2));
  const double area =
      4 * std::numbers::pi * radius * radius / (edge * edge) * looks_larger;
  EXPECT_NEAR(EstimateSurfaceArea(views, cube), area, 0.01 * area);

  // Beyond the photograph, masks are 255 but say nothing.
  views[0].unknown = views[0].mask.clone();
  EXPECT_NEAR(EstimateSurfaceArea(views, cube), area * 2 / 3, 0.01 * area);
}

TEST(EstimateSurfaceArea, IsZeroWithoutMasks) {
  EXPECT_EQ(EstimateSurfaceArea({}, {Eigen::Vector3d::Zero(), 1}), 0);
  EXPECT_EQ(EstimateSurfaceArea({View()}, {Eigen::Vector3d::Zero(), 1}), 0);
}

}  // namespace
}  // namespace octacut
