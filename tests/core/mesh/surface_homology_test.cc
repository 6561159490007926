#include "core/mesh/surface_homology.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "tests/core/mesh/label_crust.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

SurfaceHomology HomologyOf(const IndexedMesh& mesh) {
  return SurfaceHomology(mesh.positions.size(), mesh.triangles);
}

TEST(SurfaceHomology, SphereHasNoGenerator) {
  const SurfaceHomology homology = HomologyOf(Sphere(6, 0.4));
  EXPECT_EQ(homology.NumGenerators(), 0u);
  EXPECT_TRUE(homology.CrossingHalfEdges().empty());
}

TEST(SurfaceHomology, GeneratorsAreTwiceTheGenusAndTrianglesSeparate) {
  std::mt19937 random(3);
  size_t num_generators = 0;
  for (int round = 0; round < 300; ++round) {
    const IndexedMesh mesh =
        Place(LabelRandomBlock(2 + round % 5, false, random), UnitVoxels(4))
            .mesh;
    if (mesh.triangles.empty()) {
      continue;
    }
    const SurfaceHomology homology = HomologyOf(mesh);
    const MeshAudit audit = AuditMesh(mesh);
    ASSERT_EQ(homology.NumGenerators(),
              size_t(2 * audit.num_components - audit.euler_characteristic));
    num_generators += homology.NumGenerators();
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      ASSERT_EQ(homology.Class(3 * t) ^ homology.Class(3 * t + 1) ^
                    homology.Class(3 * t + 2),
                0u);
    }
    for (uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
      ASSERT_EQ(homology.Class(h), homology.Class(homology.Opposite(h)));
    }
  }
  EXPECT_GT(num_generators, 100u);
}

TEST(SurfaceHomology, LoopsAroundAndAlongATubeDifferAndDoNotSeparate) {
  // A torus of 7 by 5 vertices.
  constexpr uint32_t kAround = 7;
  constexpr uint32_t kAcross = 5;
  std::vector<std::array<uint32_t, 3>> triangles;
  const auto vertex = [&](uint32_t i, uint32_t j) {
    return i % kAround * kAcross + j % kAcross;
  };
  for (uint32_t i = 0; i < kAround; ++i) {
    for (uint32_t j = 0; j < kAcross; ++j) {
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
      triangles.push_back(
          {vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  const SurfaceHomology homology(size_t(kAround * kAcross), triangles);
  EXPECT_EQ(homology.NumGenerators(), 2u);
  const auto class_of = [&](uint32_t from, uint32_t to) {
    for (const uint32_t h : homology.Leaving().Of(from)) {
      if (triangles[h / 3][(h + 1) % 3] == to) {
        return homology.Class(h);
      }
    }
    ADD_FAILURE() << "no edge " << from << " - " << to;
    return uint64_t{0};
  };
  const auto along = [&](uint32_t j) {
    uint64_t word = 0;
    for (uint32_t i = 0; i < kAround; ++i) {
      word ^= class_of(vertex(i, j), vertex(i + 1, j));
    }
    return word;
  };
  uint64_t around = 0;
  for (uint32_t j = 0; j < kAcross; ++j) {
    around ^= class_of(vertex(2, j), vertex(2, j + 1));
  }
  EXPECT_NE(along(0), 0u);
  EXPECT_EQ(along(0), along(3));
  EXPECT_NE(around, 0u);
  EXPECT_NE(around, along(0));
}

TEST(SurfaceHomology, RefusesABorder) {
  const IndexedMesh mesh = HeightField(3, [](double, double) { return 0.0; });
  EXPECT_THROW(HomologyOf(mesh), InvariantError);
}

}  // namespace
}  // namespace octacut
