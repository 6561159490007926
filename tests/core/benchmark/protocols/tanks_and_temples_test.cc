#include "core/benchmark/protocols/tanks_and_temples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <Eigen/Geometry>

#include "core/base/error.h"
#include "tests/core/benchmark/protocols/protocol_figures.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Lattices of 0.7 tau on three faces of a cube: each point is alone in its cell
// of tau / 2, its neighbours are closer than tau and the next ones are not.
constexpr double kTau = 0.02;
constexpr double kStep = 0.7 * kTau;
constexpr int kSize = 60;

struct Corner {
  std::vector<Eigen::Vector3d> points;
  // Points of the lattice's floor beyond the middle of the x axis.
  size_t num_missing = 0;
};

Corner MakeCorner(bool with_all) {
  Corner corner;
  for (int i = 1; i <= kSize; ++i) {
    for (int j = 1; j <= kSize; ++j) {
      corner.points.emplace_back(0, i * kStep, j * kStep);
      corner.points.emplace_back(i * kStep, 0, j * kStep);
      // The floor keeps away from the walls by three steps.
      if (i >= 4 && j >= 4) {
        if (with_all || i <= kSize / 2) {
          corner.points.emplace_back(i * kStep, j * kStep, -2 * kStep);
        } else {
          ++corner.num_missing;
        }
      }
    }
  }
  return corner;
}

CropPolygon Everything() {
  CropPolygon crop;
  crop.axis = 1;
  crop.axis_min = -1;
  crop.axis_max = 2;
  crop.polygon = {{-1, 0, -1}, {2, 0, -1}, {2, 0, 2}, {-1, 0, 2}};
  return crop;
}

TEST(TanksAndTemples, PrecisionAndRecallByCounting) {
  const Corner all = MakeCorner(true);
  Corner mesh = MakeCorner(false);
  const size_t num_right = mesh.points.size();
  // Pairs of wrong points on both sides of a wall, 4 tau from it: they leave
  // the alignment as it is.
  for (int i = 10; i <= 50; ++i) {
    for (const double side : {-1.0, 1.0}) {
      mesh.points.emplace_back(side * 4 * kTau, i * kStep, 30 * kStep);
    }
  }
  const ProtocolResult result = MeasureTanksAndTemples(
      Cloud(mesh.points), Cloud(all.points), Everything(), kTau, Context(2));
  ASSERT_EQ(result.scores.size(), 1u);
  EXPECT_EQ(Figure(result, "points"), double(mesh.points.size()));
  EXPECT_EQ(Figure(result, "reference points"), double(all.points.size()));
  EXPECT_NEAR(result.scores[0].precision,
              double(num_right) / double(mesh.points.size()),
              1e-12);
  EXPECT_NEAR(Figure(result, "inlier fraction"),
              double(num_right) / double(mesh.points.size()),
              1e-12);
  // The first of the missing columns is closer than tau to the last one kept.
  const size_t num_first = mesh.num_missing / (kSize / 2);
  const double covered =
      double(all.points.size() - mesh.num_missing + num_first);
  EXPECT_NEAR(
      result.scores[0].recall, covered / double(all.points.size()), 1e-12);
  EXPECT_NEAR(
      result.scores[0].f_score,
      2 / (1 / result.scores[0].precision + 1 / result.scores[0].recall),
      1e-12);
}

TEST(TanksAndTemples, AlignsWithScale) {
  const Corner corner = MakeCorner(true);
  // No point moves further than half a step.
  Similarity3d moved;
  moved.scale = 1.002;
  moved.rotation =
      Eigen::AngleAxisd(0.002, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
  moved.translation = Eigen::Vector3d(0.002, -0.003, 0.002);
  std::vector<Eigen::Vector3d> points = corner.points;
  for (Eigen::Vector3d& point : points) {
    point = moved * point;
  }
  const ProtocolResult result = MeasureTanksAndTemples(
      Cloud(points), Cloud(corner.points), Everything(), kTau, Context(2));
  double largest = 0;
  double before = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    before = std::max(before, (points[i] - corner.points[i]).norm());
    largest = std::max(
        largest,
        (*result.reference_from_mesh * points[i] - corner.points[i]).norm());
  }
  EXPECT_GT(before, 0.2 * kTau);
  EXPECT_LT(largest, 0.01 * kTau);
  EXPECT_EQ(Figure(result, "inlier fraction"), 1);
  EXPECT_LT(Figure(result, "inlier RMSE"), 0.01 * kTau);
  EXPECT_EQ(result.scores[0].f_score, 1);
}

TEST(TanksAndTemples, CropsBothClouds) {
  const Corner corner = MakeCorner(true);
  CropPolygon crop = Everything();
  // Only y up to the middle between two rows.
  crop.axis_max = 20.5 * kStep;
  const auto inside = std::count_if(
      corner.points.begin(),
      corner.points.end(),
      [&](const Eigen::Vector3d& p) { return p.y() <= crop.axis_max; });
  const ProtocolResult result = MeasureTanksAndTemples(
      Cloud(corner.points), Cloud(corner.points), crop, kTau, Context(2));
  EXPECT_EQ(Figure(result, "points"), double(inside));
  EXPECT_EQ(Figure(result, "reference points"), double(inside));
  crop.axis_min = crop.axis_max = -5;
  EXPECT_THAT(
      [&] {
        MeasureTanksAndTemples(
            Cloud(corner.points), Cloud(corner.points), crop, kTau, Context(2));
      },
      ThrowsMessage<InputError>(HasSubstr("inside the crop volume")));
}

TEST(CropPolygon, EvenOddAlongEachAxis) {
  CropPolygon crop;
  crop.axis_min = 0;
  crop.axis_max = 1;
  // An L in the two other axes, in the order u, v.
  const double corners[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (crop.axis = 0; crop.axis < 3; ++crop.axis) {
    const int u = crop.axis == 0 ? 1 : 0;
    const int v = crop.axis == 2 ? 1 : 2;
    crop.polygon.clear();
    const auto at = [&](double pu, double pv, double along) {
      Eigen::Vector3d point;
      point[u] = pu;
      point[v] = pv;
      point[crop.axis] = along;
      return point;
    };
    for (const auto& corner : corners) {
      crop.polygon.push_back(at(corner[0], corner[1], 7));
    }
    EXPECT_TRUE(crop.Contains(at(0.5, 1.5, 0.5)));
    EXPECT_TRUE(crop.Contains(at(1.5, 0.5, 1)));
    EXPECT_FALSE(crop.Contains(at(1.5, 1.5, 0.5)));
    EXPECT_FALSE(crop.Contains(at(-0.5, 0.5, 0.5)));
    EXPECT_FALSE(crop.Contains(at(0.5, 0.5, 1.01)));
    EXPECT_FALSE(crop.Contains(at(0.5, 0.5, -0.01)));
  }
}

}  // namespace
}  // namespace octacut
