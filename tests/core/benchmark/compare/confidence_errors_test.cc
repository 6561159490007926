#include "core/benchmark/compare/confidence_errors.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/context.h"

namespace octacut {
namespace {

// A square of which the confidence grows with x from 0 to 1.
IndexedMesh Square() {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.confidence = {0, 1, 1, 0};
  return mesh;
}

ConfidenceErrors Measure(const IndexedMesh& mesh,
                         double (*error)(const Eigen::Vector3d&)) {
  const std::vector<SurfaceSample> samples =
      SampleSurface(mesh, 10000, 1, Context(1));
  std::vector<double> distances;
  for (const SurfaceSample& sample : samples) {
    distances.push_back(error(sample.point));
  }
  return MeasureConfidenceErrors(mesh, samples, distances);
}

TEST(ConfidenceErrors, AreThoseOfTheTenths) {
  const ConfidenceErrors errors =
      Measure(Square(), [](const Eigen::Vector3d& p) { return 2 - p.x(); });
  EXPECT_NEAR(errors.least_confident, 1.95, 0.002);
  EXPECT_NEAR(errors.most_confident, 1.05, 0.002);
  EXPECT_NEAR(errors.Ratio(), 1.95 / 1.05, 0.005);
}

TEST(ConfidenceErrors, AConfidenceThatIsTheSameEverywhereTellsNothing) {
  IndexedMesh mesh = Square();
  mesh.confidence.assign(4, 0.5f);
  const ConfidenceErrors errors =
      Measure(mesh, [](const Eigen::Vector3d& p) { return p.x(); });
  EXPECT_NEAR(errors.least_confident, 0.5, 0.01);
  EXPECT_NEAR(errors.Ratio(), 1, 1e-9);
}

TEST(ConfidenceErrors, WhatDoesNotCountIsLeftOut) {
  const ConfidenceErrors errors =
      Measure(Square(), [](const Eigen::Vector3d& p) {
        return p.x() < 0.5 ? std::numeric_limits<double>::quiet_NaN() : p.x();
      });
  EXPECT_NEAR(errors.least_confident, 0.525, 0.002);
  EXPECT_NEAR(errors.most_confident, 0.975, 0.002);
}

}  // namespace
}  // namespace octacut
