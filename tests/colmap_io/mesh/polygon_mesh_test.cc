#include "colmap_io/mesh/polygon_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/base/error.h"

namespace octacut {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PolygonMesh OnePolygon(const std::vector<Eigen::Vector3d>& positions) {
  PolygonMesh mesh;
  mesh.positions = positions;
  for (uint32_t i = 0; i < positions.size(); ++i) {
    mesh.corners.push_back(i);
  }
  mesh.EndFace();
  return mesh;
}

IndexedMesh TriangulateQuietly(PolygonMesh mesh) {
  std::vector<std::string> notes;
  return Triangulate(std::move(mesh), "test", &notes);
}

// Area with the sign of each triangle against `up`, and the sum of absolute
// areas: equal only when no triangle is turned over.
std::pair<double, double> Areas(const IndexedMesh& mesh,
                                const Eigen::Vector3d& up) {
  double total = 0;
  double absolute = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const double area =
        0.5 * up.dot((mesh.positions[b] - mesh.positions[a])
                         .cross(mesh.positions[c] - mesh.positions[a]));
    total += area;
    absolute += std::abs(area);
  }
  return {total, absolute};
}

TEST(Triangulate, QuadTakesTheShorterDiagonal) {
  const IndexedMesh mesh = TriangulateQuietly(
      OnePolygon({{0, 0, 0}, {3, 1, 0}, {4, 4, 0}, {1, 3, 0}}));
  EXPECT_THAT(mesh.triangles,
              ElementsAre(std::array<uint32_t, 3>{1, 2, 3},
                          std::array<uint32_t, 3>{1, 3, 0}));
}

TEST(Triangulate, ConcaveQuadIsCutInside) {
  // An arrowhead in each of its four numberings; the diagonal must leave the
  // concave corner.
  const std::vector<Eigen::Vector3d> arrow = {
      {0, 0, 1}, {4, -3, 1}, {1, 0, 1}, {4, 3, 1}};
  for (size_t shift = 0; shift < 4; ++shift) {
    std::vector<Eigen::Vector3d> turned;
    for (size_t i = 0; i < 4; ++i) {
      turned.push_back(arrow[(i + shift) % 4]);
    }
    const auto [total, absolute] = Areas(TriangulateQuietly(OnePolygon(turned)),
                                         -Eigen::Vector3d::UnitZ());
    EXPECT_DOUBLE_EQ(std::abs(total), absolute);
    EXPECT_DOUBLE_EQ(absolute, 3);
  }
}

TEST(Triangulate, ConcavePolygonsInAnyPlaneKeepTheirArea) {
  // A comb whose teeth a fan would cut through.
  std::vector<Eigen::Vector3d> comb = {{0, 0, 0}, {9, 0, 0}};
  for (int tooth = 4; tooth >= 0; --tooth) {
    comb.emplace_back(2 * tooth + 1, 5, 0);
    comb.emplace_back(2 * tooth, 5, 0);
    if (tooth > 0) {
      comb.emplace_back(2 * tooth, 1, 0);
      comb.emplace_back(2 * tooth - 1, 1, 0);
    }
  }
  const double area = 9 * 1 + 5 * 4;
  for (int turn = 0; turn < 12; ++turn) {
    const Eigen::Quaterniond rotation(
        Eigen::AngleAxisd(0.7 * turn, Eigen::Vector3d(1, 2, 3).normalized()));
    std::vector<Eigen::Vector3d> turned;
    for (const Eigen::Vector3d& p : comb) {
      turned.push_back(rotation * p + Eigen::Vector3d(100, -50, turn));
    }
    const IndexedMesh mesh = TriangulateQuietly(OnePolygon(turned));
    EXPECT_EQ(mesh.triangles.size(), comb.size() - 2);
    const auto [total, absolute] =
        Areas(mesh, rotation * Eigen::Vector3d::UnitZ());
    EXPECT_NEAR(total, area, 1e-9);
    EXPECT_NEAR(absolute, area, 1e-9);
  }
}

TEST(Triangulate, DegeneratePolygonsStillEnd) {
  const Eigen::Vector3d p(1, 2, 3);
  EXPECT_EQ(TriangulateQuietly(OnePolygon({p, p, p, p, p, p})).triangles.size(),
            4u);
  // A star that crosses itself.
  std::vector<Eigen::Vector3d> star;
  for (int i = 0; i < 7; ++i) {
    star.emplace_back(
        std::cos(i * 3 * 6.28 / 7), std::sin(i * 3 * 6.28 / 7), 0);
  }
  EXPECT_EQ(TriangulateQuietly(OnePolygon(star)).triangles.size(), 5u);
  std::vector<Eigen::Vector3d> circle;
  for (int i = 0; i < 5000; ++i) {
    circle.emplace_back(
        std::cos(i * 6.28 / 5000), std::sin(i * 6.28 / 5000), 0);
  }
  EXPECT_EQ(TriangulateQuietly(OnePolygon(circle)).triangles.size(), 4998u);
}

TEST(Triangulate, SmallFacesAreLeftOutAloud) {
  PolygonMesh mesh = OnePolygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.EndFace();
  mesh.corners.push_back(0);
  mesh.corners.push_back(1);
  mesh.EndFace();
  std::vector<std::string> notes;
  EXPECT_EQ(Triangulate(mesh, "test", &notes).triangles.size(), 1u);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("2 faces with fewer than three")));
}

TEST(Triangulate, CornerOutOfRangeIsNamed) {
  PolygonMesh mesh = OnePolygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.corners.insert(mesh.corners.end(), {0, 1, 3});
  mesh.EndFace();
  EXPECT_THAT([&] { TriangulateQuietly(mesh); },
              testing::ThrowsMessage<InputError>(
                  HasSubstr("test: face 1: vertex index 3 is out of range")));
}

TEST(QuantizeColors, FindsTheScale) {
  const std::vector<Eigen::Vector3f> unit = {{0, 0.5, 1}};
  const std::vector<Eigen::Vector3f> bytes = {{0, 0.5, 1}, {300, 128, -4}};
  EXPECT_THAT(QuantizeColors(unit, 0),
              ElementsAre(std::array<uint8_t, 3>{0, 128, 255}));
  EXPECT_THAT(QuantizeColors(bytes, 0),
              ElementsAre(std::array<uint8_t, 3>{0, 1, 1},
                          std::array<uint8_t, 3>{255, 128, 0}));
}

}  // namespace
}  // namespace octacut
