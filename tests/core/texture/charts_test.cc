#include "core/texture/charts.h"

#include <gtest/gtest.h>

#include "core/texture/atlas_layout.h"
#include "core/texture/pack_charts.h"
#include "core/texture/triangle_raster.h"
#include "tests/core/texture/small_sphere.h"

namespace octacut {
namespace {

using testing::AllAround;
using testing::PhotographsOf;
using testing::SmallSphere;

// Views by octants, with some triangles that have none.
std::vector<uint32_t> ViewsByOctant(const IndexedMesh& mesh) {
  std::vector<uint32_t> views;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d p = mesh.positions[triangle[0]] +
                              mesh.positions[triangle[1]] +
                              mesh.positions[triangle[2]];
    views.push_back(p.z() < -1.5
                        ? kNoView
                        : 6u + (p.x() > 0 ? 1u : 0u) + (p.y() > 0 ? 2u : 0u) +
                              (p.z() > 0 ? 4u : 0u));
  }
  return views;
}

// Every triangle of every page, on a grid of half texels.
TEST(Charts, DoNotOverlap) {
  const IndexedMesh mesh = SmallSphere(4);
  const Photographs photographs = PhotographsOf(AllAround(), 200);
  const std::vector<uint32_t> views = ViewsByOctant(mesh);
  AtlasLayout layout;
  layout.charts = MakeCharts(mesh,
                             FindFaceNeighbors(mesh),
                             views,
                             photographs.poses,
                             {1, 8192},
                             Context(1));
  layout.packed = PackCharts(layout.charts, {}, Context(1));
  ASSERT_EQ(layout.packed.pages.size(), 1u);
  const PageSize page = layout.packed.pages[0];
  std::vector<uint32_t> owners(size_t(4 * page.width * page.height), kNoFace);
  size_t num_points = 0;
  for (uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const uint32_t chart = layout.charts.chart_of_face[f];
    ASSERT_LT(chart, layout.charts.charts.size());
    EXPECT_EQ(layout.charts.charts[chart].view, views[f]);
    auto texels = layout.TexelsOf(f);
    for (Eigen::Vector2d& texel : texels) {
      EXPECT_GE(texel.minCoeff(), kChartMargin);
      EXPECT_LE(texel.x(), page.width - kChartMargin);
      EXPECT_LE(texel.y(), page.height - kChartMargin);
      texel *= 2;
    }
    ForPixelsInside(texels, 2 * page.width, 2 * page.height, [&](int x, int y) {
      uint32_t& owner = owners[size_t(y) * size_t(2 * page.width) + size_t(x)];
      EXPECT_EQ(owner, kNoFace);
      owner = f;
      ++num_points;
    });
  }
  EXPECT_GT(num_points, 10000u);
}

// A fold: two layers of one strip, which the same view shows at one place.
TEST(Charts, DivideWhatFoldsOver) {
  IndexedMesh mesh;
  mesh.positions = {{-0.5, -0.5, 0},
                    {0.5, -0.5, 0},
                    {0.5, 0.5, 0},
                    {-0.5, 0.5, 0},
                    {-0.4, -0.5, 0.1},
                    {-0.4, 0.5, 0.1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  const std::vector<PhotographPose> poses = {testing::PoseFrom({0, 0, 1}, 100)};
  const Charts charts = MakeCharts(mesh,
                                   FindFaceNeighbors(mesh),
                                   {0, 0, 0, 0},
                                   poses,
                                   {1, 8192},
                                   Context(1));
  ASSERT_EQ(charts.charts.size(), 2u);
  EXPECT_EQ(charts.chart_of_face[0], charts.chart_of_face[1]);
  EXPECT_EQ(charts.chart_of_face[2], charts.chart_of_face[3]);
  EXPECT_NE(charts.chart_of_face[0], charts.chart_of_face[2]);
}

// A triangle that no view sees and that is larger than any page.
TEST(Charts, ShrinkWhatNoViewSees) {
  IndexedMesh mesh = SmallSphere(4);
  std::vector<uint32_t> views = ViewsByOctant(mesh);
  const uint32_t corner = uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(),
                        {{0, 0, 0}, {0, 0.1, 0}, {0, 0.05, 1e9}});
  mesh.triangles.push_back({corner, corner + 1, corner + 2});
  views.push_back(kNoView);
  const Photographs photographs = PhotographsOf(AllAround(), 200);
  const Charts charts = MakeCharts(mesh,
                                   FindFaceNeighbors(mesh),
                                   views,
                                   photographs.poses,
                                   {1, 512},
                                   Context(1));
  for (const Chart& chart : charts.charts) {
    EXPECT_LE(std::max(chart.width, chart.height), 512);
  }
}

TEST(Charts, AreDividedToFitAPage) {
  const IndexedMesh mesh = SmallSphere(4);
  const Photographs photographs = PhotographsOf(AllAround(), 200);
  const auto longest = [&](int max_size) {
    const Charts charts = MakeCharts(mesh,
                                     FindFaceNeighbors(mesh),
                                     ViewsByOctant(mesh),
                                     photographs.poses,
                                     {1, max_size},
                                     Context(1));
    int side = 0;
    for (const Chart& chart : charts.charts) {
      side = std::max({side, chart.width, chart.height});
    }
    return side;
  };
  EXPECT_GT(longest(8192), 45);
  for (const int max_size : {39, 40, 41}) {
    EXPECT_LE(longest(max_size), max_size);
  }
}

}  // namespace
}  // namespace octacut
