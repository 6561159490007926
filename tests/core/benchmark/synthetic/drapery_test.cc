#include "core/benchmark/synthetic/drapery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/benchmark/synthetic/polygonize.h"
#include "tests/core/benchmark/synthetic/mesh_checks.h"

namespace octacut {
namespace {

struct MeasuredFold {
  double angle;  // of the groove's bottom
  double width;  // half way down
  double depth;  // below the higher of the ridges beside it
};

// The distance from the axis at which a ray toward it first meets the body.
double OuterRadius(const ImplicitShape& shape, double angle, double z) {
  const Eigen::Vector3d outward(std::cos(angle), std::sin(angle), 0);
  const Eigen::Vector3d height(0, 0, z);
  double radius = 1;
  while (shape(height + radius * outward) > 1e-5) {
    radius -=
        std::max(shape(height + radius * outward) / shape.lipschitz, 1e-5);
  }
  return radius;
}

// The folds of the cross-section at a height.
std::vector<MeasuredFold> MeasureFolds(const ImplicitShape& shape, double z) {
  constexpr int kCount = 6000;
  const auto angle_of = [](int i) { return 2 * std::numbers::pi * i / kCount; };
  std::vector<double> radii;
  for (int i = 0; i < kCount; ++i) {
    radii.push_back(OuterRadius(shape, angle_of(i), z));
  }
  const double ridge = *std::max_element(radii.begin(), radii.end());
  // Grooves between places that are no more than a little below the ridges.
  std::vector<MeasuredFold> folds;
  const auto at = [&](int i) { return radii[i % kCount]; };
  int start = 0;
  while (at(start) < ridge - 0.004) {
    ++start;
  }
  for (int i = start; i < start + kCount; ++i) {
    if (at(i) >= ridge - 0.004) {
      continue;
    }
    int end = i;
    int bottom = i;
    for (; at(end) < ridge - 0.004; ++end) {
      bottom = at(end) < at(bottom) ? end : bottom;
    }
    const double middle = (ridge + at(bottom)) / 2;
    int below = 0;
    for (int k = i; k < end; ++k) {
      below += at(k) < middle;
    }
    folds.push_back({angle_of(bottom % kCount),
                     middle * 2 * std::numbers::pi * below / kCount,
                     ridge - at(bottom)});
    i = end;
  }
  return folds;
}

TEST(MakeDrapery, FoldsAreAsWideAndDeepAsAsked) {
  for (const double depth : {1.0, 2.0, 4.0}) {
    const DraperyOptions options{.depth = depth};
    const ImplicitShape shape = MakeDrapery(options);
    // Just above the rounded hem; narrower there than at it.
    const double z = -0.70;
    const double scale = 1 - 0.28 * 0.15 / 1.7;
    const std::vector<MeasuredFold> folds = MeasureFolds(shape, z);
    ASSERT_GT(folds.size(), 20u) << depth;
    double widest = 0;
    double narrowest = 1;
    for (const MeasuredFold& fold : folds) {
      EXPECT_NEAR(fold.depth / fold.width, depth, 0.2 * depth) << fold.angle;
      widest = std::max(widest, fold.width / scale);
      narrowest = std::min(narrowest, fold.width / scale);
    }
    EXPECT_NEAR(widest, options.max_width, 0.15 * options.max_width) << depth;
    EXPECT_NEAR(narrowest, options.min_width, 0.2 * options.min_width) << depth;
  }
}

TEST(MakeDrapery, FoldsGetNarrowerFromFrontToBack) {
  const std::vector<MeasuredFold> folds = MeasureFolds(MakeDrapery({}), -0.7);
  for (const MeasuredFold& fold : folds) {
    // Turned aside by the sway.
    const double x = std::cos(fold.angle - 0.16 * std::sin(3.2 * -0.7));
    if (x > 0.8) {
      EXPECT_GT(fold.width, 0.055);
    } else if (x < -0.8) {
      EXPECT_LT(fold.width, 0.04);
    }
  }
}

TEST(MakeDrapery, IsOneClosedPieceWithoutHandles) {
  // The default's narrowest folds take a finer mesh: objects_test has it.
  for (const double depth : {1.0, 4.0}) {
    PolygonizeOptions options;
    options.resolution = 90;
    options.smoothing_rounds = 0;
    const ImplicitShape shape =
        MakeDrapery({.min_width = 0.035, .depth = depth});
    const IndexedMesh mesh = Polygonize(shape, options, Context(2));
    EXPECT_TRUE(IsClosedAndOriented(mesh)) << depth;
    EXPECT_EQ(CountComponents(mesh), 1) << depth;
    EXPECT_EQ(Genus(mesh), 0) << depth;
  }
}

TEST(MakeDrapery, KeepsItsBoundOnTheSlope) {
  const ImplicitShape shape = MakeDrapery({.depth = 4});
  double steepest = 0;
  for (int i = 0; i < 20000; ++i) {
    // In and about the body.
    const Eigen::Vector3d p(2.2 * std::fmod(0.7548776662 * i, 1) - 1.1,
                            2.2 * std::fmod(0.5698402909 * i, 1) - 1.1,
                            2.2 * std::fmod(0.3819660113 * i, 1) - 1.1);
    steepest = std::max(steepest, ImplicitGradient(shape, p, 1e-5).norm());
  }
  EXPECT_LE(steepest, shape.lipschitz);
  EXPECT_GT(steepest, 1);
}

TEST(MakeDrapery, RefusesWhatDoesNotFit) {
  EXPECT_THROW(MakeDrapery({.max_width = 0.2, .depth = 3}), OptionError);
  EXPECT_THROW(MakeDrapery({.max_width = 1, .depth = 0.39}), OptionError);
}

}  // namespace
}  // namespace octacut
