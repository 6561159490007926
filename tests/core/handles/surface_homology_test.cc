#include "core/handles/surface_homology.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "tests/core/extract/label_crust.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

HalfEdges HalfEdgesOf(const IndexedMesh& mesh) {
  return HalfEdges(mesh.positions.size(), mesh.triangles, Context(2));
}

TEST(HalfEdges, LeadAroundTrianglesAndVertices) {
  const IndexedMesh mesh = Sphere(6, 0.4);
  const HalfEdges half_edges = HalfEdgesOf(mesh);
  ASSERT_EQ(half_edges.Size(), 3 * mesh.triangles.size());
  for (uint32_t h = 0; h < half_edges.Size(); ++h) {
    const uint32_t o = half_edges.Opposite(h);
    ASSERT_EQ(half_edges.Opposite(o), h);
    ASSERT_EQ(half_edges.Origin(o), half_edges.End(h));
    ASSERT_EQ(half_edges.End(o), half_edges.Origin(h));
    const uint32_t vertex = half_edges.Origin(h);
    size_t count = 0;
    uint32_t around = h;
    do {
      ASSERT_EQ(half_edges.Origin(around), vertex);
      around = half_edges.NextAround(around);
      ++count;
    } while (around != h);
    ASSERT_EQ(count, half_edges.Leaving(vertex).size());
  }
}

TEST(HalfEdges, RefuseABorder) {
  const IndexedMesh mesh = HeightField(3, [](double, double) { return 0.0; });
  EXPECT_THROW(HalfEdgesOf(mesh), InvariantError);
}

TEST(SurfaceHomology, SphereHasNoGenerator) {
  const IndexedMesh mesh = Sphere(6, 0.4);
  const HalfEdges half_edges = HalfEdgesOf(mesh);
  const SurfaceHomology homology(half_edges, Context(1));
  EXPECT_EQ(homology.NumGenerators(), 0u);
  EXPECT_TRUE(homology.CrossingHalfEdges().empty());
}

TEST(SurfaceHomology, GeneratorsAreTwiceTheGenusAndTrianglesSeparate) {
  std::mt19937 random(3);
  size_t num_generators = 0;
  for (int round = 0; round < 300; ++round) {
    const IndexedMesh mesh =
        Place(LabelRandomBlock(2 + round % 5, false, random), UnitVoxels(4));
    if (mesh.triangles.empty()) {
      continue;
    }
    const HalfEdges half_edges = HalfEdgesOf(mesh);
    const SurfaceHomology homology(half_edges, Context(1));
    const MeshAudit audit = AuditMesh(mesh, Context(1));
    ASSERT_EQ(homology.NumGenerators(),
              size_t(2 * audit.num_components - audit.euler_characteristic));
    num_generators += homology.NumGenerators();
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      ASSERT_EQ(homology.Class(3 * t) ^ homology.Class(3 * t + 1) ^
                    homology.Class(3 * t + 2),
                0u);
    }
    for (uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
      ASSERT_EQ(homology.Class(h), homology.Class(half_edges.Opposite(h)));
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
  const HalfEdges half_edges(size_t(kAround * kAcross), triangles, Context(1));
  const SurfaceHomology homology(half_edges, Context(1));
  EXPECT_EQ(homology.NumGenerators(), 2u);
  const auto class_of = [&](uint32_t from, uint32_t to) {
    for (const uint32_t h : half_edges.Leaving(from)) {
      if (half_edges.End(h) == to) {
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

}  // namespace
}  // namespace octacut
