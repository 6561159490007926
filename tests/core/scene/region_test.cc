#include "core/scene/region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

#include "core/base/error.h"
#include "tests/core/base/recorder.h"
#include "tests/core/scene/synthetic_views.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using testing::Recorder;
using testing::RenderAllAround;
using testing::RenderView;
using testing::Sphere;

std::vector<Eigen::Vector3d> PointsOnSphere(const Eigen::Vector3d& middle,
                                            double radius,
                                            size_t count) {
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3d> points(count);
  for (Eigen::Vector3d& point : points) {
    point = middle + radius * Eigen::Vector3d::NullaryExpr([&] {
                                return normal(generator);
                              }).normalized();
  }
  return points;
}

template <typename Function>
std::string InputErrorOf(Function&& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

// Scales and offsets that a mapper may choose.
class RegionScale : public ::testing::TestWithParam<double> {};

TEST_P(RegionScale, IsTightAroundASphere) {
  const double scale = GetParam();
  const Eigen::Vector3d middle = scale * Eigen::Vector3d(5, -3, 8);
  const auto views =
      RenderAllAround(middle, 4 * scale, 300, Sphere(middle, scale));
  const Region region = EstimateRegion(views, {}, {}, Context(2));
  EXPECT_EQ(region.source, RegionSource::kSilhouettes);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(region.box.min()[axis], middle[axis] - scale);
    EXPECT_GE(region.box.max()[axis], middle[axis] + scale);
    EXPECT_LE(region.box.sizes()[axis], 1.15 * 2 * scale);
  }
  EXPECT_NEAR(
      region.cube.edge, 1.08 * region.box.sizes().maxCoeff(), 1e-9 * scale);
  EXPECT_TRUE(region.cube.Center().isApprox(region.box.center()));
}
INSTANTIATE_TEST_SUITE_P(Region, RegionScale, ::testing::Values(1e-4, 1, 1e5));

TEST(Region, AToleranceOfTheMasksMakesTheBoxLargerButNotTheCube) {
  const Eigen::Vector3d middle(1, 2, 3);
  auto views = RenderAllAround(middle, 4, 300, Sphere(middle, 1));
  for (View& view : views) {
    view.scale = 0.5;
  }
  const Region strict = EstimateRegion(views, {}, {}, Context(2));
  RegionOptions options;
  options.mask_tolerance = 6;
  const Region tolerant = EstimateRegion(views, {}, options, Context(2));
  EXPECT_EQ(tolerant.cube.edge, strict.cube.edge);
  EXPECT_EQ(tolerant.cube.min_corner, strict.cube.min_corner);
  // Six pixels of the photograph are three of the view.
  const double slack = 3 * 4 / views[0].camera.fx;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(tolerant.box.sizes()[axis] - strict.box.sizes()[axis],
                2 * slack,
                0.1 * slack);
  }
  options.mask_tolerance = 64;
  const Region largest = EstimateRegion(views, {}, options, Context(2));
  // Half of the cube's margin of 8 % is left, so that a surface can close in
  // it.
  EXPECT_TRUE(
      largest.box.sizes().isApproxToConstant(strict.cube.edge * 1.04 / 1.08));
}

TEST(Region, HoldsALongObjectOffTheMiddle) {
  const Eigen::AlignedBox3d object(Eigen::Vector3d(-0.1, -0.9, -0.2),
                                   Eigen::Vector3d(0.1, 0.6, 0.3));
  const auto views = RenderAllAround({0, 0, 0}, 4, 300, testing::Box(object));
  const Region region = EstimateRegion(views, {}, {}, Context(2));
  // The mask holds pixels whose centre is object: half a pixel may be missing.
  const Eigen::Vector3d pixel = Eigen::Vector3d::Constant(4.0 / 300);
  EXPECT_TRUE(region.box.contains(
      Eigen::AlignedBox3d(object.min() + pixel, object.max() - pixel)));
  EXPECT_LE(region.box.sizes().y(), 1.15 * 1.5);
}

TEST(Region, DoesNotCutWhatSomeViewsHaveOutsideTheirFrame) {
  // Long enough to leave the frame of every view near its side.
  const Eigen::AlignedBox3d object(Eigen::Vector3d(-0.3, -1.6, -0.3),
                                   Eigen::Vector3d(0.3, 1.6, 0.3));
  const auto views = RenderAllAround({0, 0, 0}, 4, 370, testing::Box(object));
  size_t open = 0;
  for (const View& view : views) {
    open += view.mask.at<uint8_t>(120, 0) != 0;
  }
  ASSERT_GT(open, 3u);
  ASSERT_LT(open, views.size() - 3);
  const Region region = EstimateRegion(views, {}, {}, Context(2));
  EXPECT_EQ(region.source, RegionSource::kSilhouettes);
  const Eigen::Vector3d pixel = Eigen::Vector3d::Constant(4.0 / 300);
  EXPECT_TRUE(region.box.contains(
      Eigen::AlignedBox3d(object.min() + pixel, object.max() - pixel)));
  EXPECT_LE(region.box.sizes().y(), 1.2 * 3.2);
}

std::vector<View> FromOneSide(double focal) {
  std::vector<View> views;
  for (int i = -3; i <= 3; ++i) {
    views.push_back(RenderView(
        {4, 0.3 * i, 0.1 * (i % 2)}, {0, 0, 0}, focal, Sphere({0, 0, 0}, 1)));
  }
  return views;
}

TEST(Region, FallsBackToSparsePointsForCamerasOnOneSide) {
  Recorder recorder;
  std::vector<Eigen::Vector3d> points = PointsOnSphere({0, 0, 0}, 1, 500);
  // Background that the masks exclude, and gross outliers.
  for (int i = 0; i < 300; ++i) {
    points.emplace_back(-3 + 0.01 * i, 4, 2);
  }
  points.emplace_back(-90, 0, 0);
  const Region region =
      EstimateRegion(FromOneSide(300), points, {}, Context(2, &recorder));
  EXPECT_EQ(region.source, RegionSource::kSparsePoints);
  ASSERT_EQ(recorder.warnings.size(), 1u);
  EXPECT_THAT(recorder.warnings[0], HasSubstr("sparse points"));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(region.box.min()[axis], -0.97);
    EXPECT_GE(region.box.max()[axis], 0.97);
    EXPECT_LE(region.box.sizes()[axis], 3.1);
  }
}

TEST(Region, AsksForABoxWhenNothingBoundsTheObject) {
  // Every view is filled by the object up to its frame.
  const auto views = RenderAllAround({0, 0, 0}, 4, 900, Sphere({0, 0, 0}, 1));
  EXPECT_THAT(InputErrorOf([&] { EstimateRegion(views, {}, {}, Context(1)); }),
              HasSubstr("Set `bounding_box` to x0,y0,z0,x1,y1,z1"));
  RegionOptions options;
  options.bounding_box = {Eigen::Vector3d(-1, -1, -1),
                          Eigen::Vector3d(1, 2, 1)};
  const Region region = EstimateRegion(views, {}, options, Context(1));
  EXPECT_EQ(region.source, RegionSource::kGiven);
  EXPECT_TRUE(region.box.isApprox(*options.bounding_box));
  EXPECT_NEAR(region.cube.edge, 3 * 1.08, 1e-12);
  // Points bound it too.
  EXPECT_EQ(
      EstimateRegion(views, PointsOnSphere({0, 0, 0}, 1, 200), {}, Context(1))
          .source,
      RegionSource::kSparsePoints);
}

TEST(Region, RefusesMasksThatDoNotFitThePoses) {
  auto views = RenderAllAround({0, 0, 0}, 4, 300, Sphere({0, 0, 0}, 0.3));
  const auto error = [&] {
    return InputErrorOf([&] { EstimateRegion(views, {}, {}, Context(1)); });
  };
  views[3] = RenderView({4, 0, 0}, {0, 0, 0}, 300, Sphere({0, 1, 0.8}, 0.1));
  views[3].name = "abc/012.jpg";
  EXPECT_THAT(error(), HasSubstr("do not fit the camera poses"));
  EXPECT_THAT(error(), HasSubstr("all masks except that of abc/012.jpg fit"));
  views[1] = RenderView({0, 4, 0}, {0, 0, 0}, 300, Sphere({1, 0, 0.8}, 0.1));
  EXPECT_THAT(error(), HasSubstr("(the masks may be wrong"));
  EXPECT_THROW(EstimateRegion({}, {}, {}, Context(1)), InputError);
}

TEST(Region, IsTheSameForAnyNumberOfThreads) {
  const auto views = RenderAllAround({1, 0, 2}, 4, 300, Sphere({1, 0, 2}, 1));
  const Region one = EstimateRegion(views, {}, {}, Context(1));
  const Region four = EstimateRegion(views, {}, {}, Context(4));
  EXPECT_EQ(one.box.min(), four.box.min());
  EXPECT_EQ(one.box.max(), four.box.max());
  EXPECT_EQ(one.cube.edge, four.cube.edge);
}

TEST(Region, PointsInsideMasksDropsBackground) {
  const auto views = RenderAllAround({0, 0, 0}, 4, 300, Sphere({0, 0, 0}, 1));
  const std::vector<Eigen::Vector3d> points = {
      {0, 0, 0.9}, {0, 0, 1.3}, {0.5, 0.5, 0}, {1.2, 0, 0}, {40, 0, 0}};
  EXPECT_EQ(PointsInsideMasks(views, points, 0.9), (std::vector<size_t>{0, 2}));
}

TEST(RegionOptions, DefaultsAreValidAndBadValuesAreNamed) {
  EXPECT_NO_THROW(RegionOptions().Check());
  const auto message = [](auto&& change) -> std::string {
    RegionOptions options;
    change(options);
    try {
      options.Check();
    } catch (const OptionError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message([](auto& o) { o.mask_tolerance = -1; }),
              HasSubstr("mask_tolerance"));
}

TEST(RegionOptions, BoundingBoxFromNumbers) {
  const Eigen::AlignedBox3d box = BoundingBoxFromNumbers({1, 2, 3, 4, 5, 6});
  EXPECT_EQ(box.min(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(box.max(), Eigen::Vector3d(4, 5, 6));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(BoundingBoxFromNumbers({1, 2, 3, 4, 5}), OptionError);
  EXPECT_THROW(BoundingBoxFromNumbers({1, 2, 3, 1, 5, 6}), OptionError);
  EXPECT_THROW(BoundingBoxFromNumbers({1, 2, 7, 4, 5, 6}), OptionError);
  EXPECT_THROW(BoundingBoxFromNumbers({1, 2, nan, 4, 5, 6}), OptionError);
  // Beyond what floats can hold the squares of.
  EXPECT_THROW(BoundingBoxFromNumbers({0, 0, 0, 1, 1, 1e-40}), OptionError);
  EXPECT_THROW(BoundingBoxFromNumbers({-1e39, 0, 0, 1, 1, 1}), OptionError);
}

TEST(Region, FloatsMustResolveTheVoxels) {
  BoundingCube cube;
  cube.edge = 10;
  cube.min_corner = {-5, -5, 0};
  CheckFloatsResolve(cube, 12);
  cube.min_corner = {4e3, 0, 0};
  CheckFloatsResolve(cube, 9);
  EXPECT_THROW(CheckFloatsResolve(cube, 12), InputError);
  cube.min_corner = {4.5e5, -5.4e6, 100};  // as of a map's grid
  try {
    CheckFloatsResolve(cube, 7);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("size of 10"));
    EXPECT_THAT(error.what(), HasSubstr("coordinates up to 5.4e+06"));
  }
}

}  // namespace
}  // namespace octacut
