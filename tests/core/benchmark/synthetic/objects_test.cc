#include "core/benchmark/synthetic/objects.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/benchmark/synthetic/polygonize.h"
#include "tests/core/benchmark/synthetic/mesh_checks.h"

namespace octacut {
namespace {

class Objects : public ::testing::TestWithParam<std::string> {};

TEST_P(Objects, HaveTheTopologyTheySayAndTheReferenceLiesOnThem) {
  const SyntheticObject object = MakeObject(GetParam());
  PolygonizeOptions options;
  // The drapery's narrowest folds are a hundredth of it.
  options.resolution = GetParam() == "drapery" ? 130 : 60;
  const IndexedMesh mesh = Polygonize(object.shape, options, Context(2));
  EXPECT_TRUE(IsClosedAndOriented(mesh));
  EXPECT_EQ(CountComponents(mesh), object.num_components);
  EXPECT_EQ(Genus(mesh), object.genus);
  EXPECT_GT(Volume(mesh), 0);

  Eigen::AlignedBox3d box;
  double worst = 0;
  for (const Eigen::Vector3d& position : mesh.positions) {
    box.extend(position);
    worst = std::max(worst, std::abs(object.shape(position)));
  }
  const double diagonal = box.diagonal().norm();
  EXPECT_LT(worst, 1e-5 * diagonal);
  // Between the vertices too: the mean over the triangles' middles.
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    sum += std::abs(object.shape((mesh.positions[triangle[0]] +
                                  mesh.positions[triangle[1]] +
                                  mesh.positions[triangle[2]]) /
                                 3));
  }
  EXPECT_LT(sum / mesh.triangles.size(), 4e-4 * diagonal);
}

INSTANTIATE_TEST_SUITE_P(Named, Objects, ::testing::ValuesIn(ObjectNames()));

TEST(MakeObject, CupIsAsDeepAsAsked) {
  for (const double depth : {0.5, 1.0, 1.5}) {
    const SyntheticObject cup = MakeObject("cup", {.cup_depth = depth});
    const double top = cup.shape.box.max().z();
    // On the axis: open from the top down to the bottom of the cavity.
    EXPECT_GT(cup.shape({0, 0, top - depth + 0.01}), 0) << depth;
    EXPECT_LT(cup.shape({0, 0, top - depth - 0.01}), 0) << depth;
    EXPECT_GT(cup.shape({0.48, 0, top - depth / 2}), 0);
    EXPECT_LT(cup.shape({0.52, 0, top - depth / 2}), 0);
  }
}

TEST(MakeObject, RodsAreAsThickAsAsked) {
  const double radius = 0.03;
  const SyntheticObject rods = MakeObject("rods", {.rod_radius = radius});
  PolygonizeOptions options;
  options.resolution = 120;
  const IndexedMesh mesh = Polygonize(rods.shape, options, Context(2));
  // Three rods of length 1.8: nearly the volume of as many cylinders.
  const double expected = 3 * 1.8 * 3.14159265 * radius * radius;
  EXPECT_NEAR(Volume(mesh) / expected, 1, 0.05);
}

TEST(MakeObject, FingersAreAsThickAsAsked) {
  for (const double radius : {0.02, 0.04, 0.065}) {
    const SyntheticObject hand =
        MakeObject("fingers", {.finger_radius = radius});
    // Across the tip of the longest finger.
    const Eigen::Vector3d tip(-0.195, -0.05, 0.7);
    EXPECT_NEAR(hand.shape(tip), -radius, 1e-3) << radius;
    EXPECT_NEAR(
        hand.shape(tip + Eigen::Vector3d(0, 2 * radius, 0)), radius, 2e-3)
        << radius;
  }
}

TEST(MakeObject, RefusesUnknownNamesAndBadParameters) {
  EXPECT_THROW(MakeObject("teapot"), OptionError);
  EXPECT_THROW(MakeObject("cup", {.cup_depth = 0}), OptionError);
  EXPECT_THROW(MakeObject("rods", {.rod_radius = 1}), OptionError);
  EXPECT_THROW(MakeObject("fingers", {.finger_radius = 0.2}), OptionError);
}

}  // namespace
}  // namespace octacut
