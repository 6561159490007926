#include "core/evidence/neighbor_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/core/views/random_views.h"

namespace octacut {
namespace {

// Views that look at the cube's centre from the given directions.
ViewSet ViewsFrom(const std::vector<Eigen::Vector3d>& directions) {
  ViewSet views(directions.size());
  for (size_t i = 0; i < views.size(); ++i) {
    views[i].projection.center =
        (Eigen::Vector3d::Constant(0.5) + 2.5 * directions[i]).cast<float>();
  }
  return views;
}

double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * 180 / std::numbers::pi;
}

TEST(SelectNeighborViews, TakesThoseNearestToFifteenDegrees) {
  testing::Random random(1);
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < 40; ++i) {
    directions.push_back(random.Direction());
  }
  for (const int count : {2, 4, 8}) {
    const auto neighbors =
        SelectNeighborViews(ViewsFrom(directions), count, 5, 40);
    ASSERT_EQ(neighbors.size(), directions.size());
    for (size_t i = 0; i < neighbors.size(); ++i) {
      std::vector<double> expected;
      for (size_t j = 0; j < directions.size(); ++j) {
        const double angle = AngleBetween(directions[i], directions[j]);
        if (j != i && angle >= 5 && angle <= 40) {
          expected.push_back(std::abs(angle - 15));
        }
      }
      std::sort(expected.begin(), expected.end());
      expected.resize(std::min(expected.size(), size_t(count)));
      ASSERT_EQ(neighbors[i].size(), expected.size());
      for (size_t k = 0; k < expected.size(); ++k) {
        const int j = neighbors[i][k];
        EXPECT_NE(j, int(i));
        EXPECT_NEAR(std::abs(AngleBetween(directions[i], directions[j]) - 15),
                    expected[k],
                    0.05);
        EXPECT_EQ(std::count(neighbors[i].begin(), neighbors[i].end(), j), 1);
      }
    }
  }
}

TEST(SelectNeighborViews, OnATurntableTakesBothSides) {
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < 24; ++i) {
    const double angle = 2 * std::numbers::pi * i / 24;
    directions.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  const auto neighbors = SelectNeighborViews(ViewsFrom(directions), 4, 4, 45);
  for (int i = 0; i < 24; ++i) {
    ASSERT_EQ(neighbors[i].size(), 4u);
    std::vector<int> nearest = {neighbors[i][0], neighbors[i][1]};
    std::sort(nearest.begin(), nearest.end());
    std::vector<int> expected = {(i + 1) % 24, (i + 23) % 24};
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(nearest, expected);
  }
}

TEST(SelectNeighborViews, LeavesOutWhatIsTooNearOrTooFar) {
  const auto at = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
  };
  const auto neighbors =
      SelectNeighborViews(ViewsFrom({at(0), at(2), at(20), at(90)}), 4, 4, 45);
  EXPECT_EQ(neighbors[0], std::vector<int>{2});
  EXPECT_EQ(neighbors[1], std::vector<int>{2});
  EXPECT_EQ(neighbors[2], (std::vector<int>{1, 0}));
  EXPECT_TRUE(neighbors[3].empty());
  EXPECT_TRUE(SelectNeighborViews(ViewSet(), 4, 4, 45).empty());
}

}  // namespace
}  // namespace octacut
