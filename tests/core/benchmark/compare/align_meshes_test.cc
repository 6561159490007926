#include "core/benchmark/compare/align_meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "tests/core/base/recorder.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

Similarity3d TestSimilarity(double angle, double scale, double shift) {
  Similarity3d similarity;
  similarity.scale = scale;
  similarity.rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d(2, -1, 2) / 3)
                            .toRotationMatrix();
  similarity.translation = shift * Eigen::Vector3d(1, -2, 0.5);
  return similarity;
}

AlignMeshesOptions FewSamples() {
  AlignMeshesOptions options;
  options.num_samples = 3000;
  return options;
}

// The largest distance that a vertex keeps after the alignment.
double Misplacement(const IndexedMesh& mesh,
                    const Similarity3d& moved_from_mesh,
                    const Similarity3d& mesh_from_moved) {
  double largest = 0;
  for (const Eigen::Vector3d& p : mesh.positions) {
    largest =
        std::max(largest, (mesh_from_moved * (moved_from_mesh * p) - p).norm());
  }
  return largest;
}

TEST(Similarity, AlgebraOfTransforms) {
  const Similarity3d a = TestSimilarity(0.4, 1.5, 2);
  const Similarity3d b = TestSimilarity(-1.1, 0.3, -1);
  const Eigen::Vector3d x(0.3, -4, 2);
  EXPECT_TRUE(((a * b) * x).isApprox(a * (b * x), 1e-12));
  EXPECT_TRUE((a.Inverse() * (a * x)).isApprox(x, 1e-12));
  IndexedMesh mesh = Cube(1);
  mesh.normals.assign(mesh.positions.size(), Eigen::Vector3f::UnitX());
  const IndexedMesh moved = TransformMesh(mesh, a);
  EXPECT_TRUE(moved.positions[3].isApprox(a * mesh.positions[3]));
  EXPECT_TRUE(moved.normals[3].isApprox(a.rotation.col(0).cast<float>()));
}

TEST(AlignMeshes, RecoversAKnownSimilarity) {
  const IndexedMesh mesh = Potato(20);
  for (const Similarity3d& moved : {TestSimilarity(0.001, 1.0003, 0.0005),
                                    TestSimilarity(0.15, 1.05, 0.05),
                                    TestSimilarity(-0.2, 0.93, 0.08)}) {
    const MeshAlignment result =
        AlignMeshes(TransformMesh(mesh, moved), mesh, FewSamples(), Context(2));
    EXPECT_LT(Misplacement(mesh, moved, result.reference_from_mesh), 1e-5);
    EXPECT_NEAR(result.reference_from_mesh.scale * moved.scale, 1, 1e-6);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(result.rms_after, 1e-6);
    EXPECT_GT(result.rms_before, 1e-4);
    EXPECT_LT(result.num_iterations, 40);
  }
}

TEST(AlignMeshes, ScaleAndPositionOfTheWorldDoNotMatter) {
  Similarity3d far;
  far.scale = 1e-3;
  far.translation = {1000, -2000, 500};
  const IndexedMesh reference = TransformMesh(Potato(15), far);
  const Similarity3d moved =
      far * TestSimilarity(0.05, 1.02, 0.02) * far.Inverse();
  const MeshAlignment result = AlignMeshes(
      TransformMesh(reference, moved), reference, FewSamples(), Context(2));
  EXPECT_LT(Misplacement(reference, moved, result.reference_from_mesh), 1e-8);
}

TEST(AlignMeshes, RefusesAReferenceOfOnePoint) {
  IndexedMesh point;
  point.positions.assign(3, Eigen::Vector3d(1, 2, 3));
  AlignMeshesOptions options = FewSamples();
  for (const bool global_search : {false, true}) {
    options.global_search = global_search;
    EXPECT_THROW(AlignMeshes(Potato(15), point, options, Context(1)),
                 InputError);
  }
}

TEST(AlignMeshes, MissingPartsAreRejected) {
  const IndexedMesh whole = Potato(24);
  const IndexedMesh partial = KeepTriangles(
      whole, [](const Eigen::Vector3d& p) { return p.z() > -0.35; });
  const Similarity3d moved = TestSimilarity(0.05, 1.02, 0.02);
  const AlignMeshesOptions options = FewSamples();
  const MeshAlignment result =
      AlignMeshes(TransformMesh(partial, moved), whole, options, Context(2));
  EXPECT_LT(Misplacement(whole, moved, result.reference_from_mesh), 1e-4);
  const MeshAlignment turned =
      AlignMeshes(TransformMesh(whole, moved), partial, options, Context(2));
  EXPECT_LT(Misplacement(whole, moved, turned.reference_from_mesh), 1e-4);
}

TEST(AlignMeshes, FilteredPartsOfTheReferenceDoNotCount) {
  const IndexedMesh whole = Potato(24);
  // Wrong below, where the reference does not count.
  IndexedMesh mesh = whole;
  for (Eigen::Vector3d& p : mesh.positions) {
    p.z() = p.z() < -0.2 ? -0.2 + 0.5 * (p.z() + 0.2) : p.z();
  }
  const Similarity3d moved = TestSimilarity(0.02, 1.01, 0.01);
  const ReferenceFilter filter = [](uint32_t, const Eigen::Vector3d& point) {
    return point.z() > -0.1;
  };
  const MeshAlignment result = AlignMeshes(
      TransformMesh(mesh, moved), whole, FewSamples(), Context(2), filter);
  EXPECT_LT(Misplacement(whole, moved, result.reference_from_mesh), 1e-3);
  EXPECT_THROW(
      AlignMeshes(mesh,
                  whole,
                  FewSamples(),
                  Context(2),
                  [](uint32_t, const Eigen::Vector3d&) { return false; }),
      InputError);
}

// Adds a plate through the mesh with `share` of the joint area.
IndexedMesh WithPlate(const IndexedMesh& mesh, double share) {
  const double area = AuditMesh(mesh, Context(1)).area;
  const double side = std::sqrt(area * share / (1 - share));
  IndexedMesh plate = HeightField(20, [](double, double) { return 0.0; });
  for (Eigen::Vector3d& p : plate.positions) {
    p = side * (p - Eigen::Vector3d(0.2, 0.4, 0)) +
        Eigen::Vector3d(0.3, 0, 0.9);
  }
  return Joined(mesh, plate);
}

TEST(AlignMeshes, WrongPartsAreRejected) {
  const IndexedMesh whole = Potato(24);
  const Similarity3d moved = TestSimilarity(0.1, 1.04, 0.04);
  const MeshAlignment result =
      AlignMeshes(TransformMesh(WithPlate(whole, 0.2), moved),
                  whole,
                  FewSamples(),
                  Context(2));
  EXPECT_LT(Misplacement(whole, moved, result.reference_from_mesh), 1e-4);
  EXPECT_LT(result.inliers, 0.9);
  EXPECT_GT(result.inliers, 0.7);
}

TEST(AlignMeshes, ACloudTakesTheNormalsOfTheMesh) {
  const IndexedMesh mesh = Potato(40);
  IndexedMesh cloud;
  cloud.positions = Potato(37).positions;
  const Similarity3d moved = TestSimilarity(0.1, 1.04, 0.04);
  const MeshAlignment result =
      AlignMeshes(TransformMesh(mesh, moved), cloud, FewSamples(), Context(2));
  EXPECT_LT(Misplacement(mesh, moved, result.reference_from_mesh), 0.01);
  EXPECT_THROW(AlignMeshes(cloud, cloud, FewSamples(), Context(2)), InputError);
}

class GlobalSearchTest : public ::testing::Test {
 protected:
  static AlignMeshesOptions Options() {
    AlignMeshesOptions options = FewSamples();
    options.global_search = true;
    return options;
  }
  // A torus with bumps that only one rotation matches.
  static IndexedMesh BumpyTorus(uint32_t n) {
    IndexedMesh mesh;
    const auto at = [&](uint32_t i, uint32_t j) {
      return (i % (2 * n)) * n + j % n;
    };
    for (uint32_t i = 0; i < 2 * n; ++i) {
      for (uint32_t j = 0; j < n; ++j) {
        const double u = 2 * kPi * i / (2 * n);
        const double v = 2 * kPi * j / n;
        const double r = 0.35 + 0.08 * std::sin(2 * u + 0.4) +
                         0.06 * std::cos(3 * u) * std::sin(v);
        const double x = 1 + 0.25 * std::cos(u) + r * std::cos(v);
        mesh.positions.emplace_back(
            x * std::cos(u), 0.8 * x * std::sin(u), r * std::sin(v));
        mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
    return mesh;
  }
  // Turned by more than half a turn, five times as large, far away.
  static Similarity3d FarAway(double angle) {
    Similarity3d moved = TestSimilarity(angle, 5, 30);
    return moved;
  }
  static constexpr double kPi = 3.14159265358979323846;
};

TEST_F(GlobalSearchTest, FindsAnyRotationWithNoiseAndWrongParts) {
  const IndexedMesh torus = BumpyTorus(30);
  for (const double angle : {3.1, -1.7}) {
    IndexedMesh mesh = WithPlate(torus, 0.2);
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0, 0.01);
    for (Eigen::Vector3d& p : mesh.positions) {
      p += Eigen::Vector3d(normal(random), normal(random), normal(random));
    }
    const Similarity3d moved = FarAway(angle);
    const MeshAlignment result =
        AlignMeshes(TransformMesh(mesh, moved), torus, Options(), Context(2));
    // The noise is 0.3 % of the diagonal.
    EXPECT_LT(Misplacement(torus, moved, result.reference_from_mesh), 0.01)
        << angle;
    EXPECT_FALSE(result.is_ambiguous);
  }
}

TEST_F(GlobalSearchTest, FindsPartsOfTheReference) {
  const IndexedMesh torus = BumpyTorus(30);
  const IndexedMesh part = KeepTriangles(
      torus, [](const Eigen::Vector3d& p) { return p.x() > -0.5; });
  EXPECT_LT(AuditMesh(part, Context(1)).area,
            0.8 * AuditMesh(torus, Context(1)).area);
  const Similarity3d moved = FarAway(2.5);
  const MeshAlignment result =
      AlignMeshes(TransformMesh(part, moved), torus, Options(), Context(2));
  EXPECT_LT(Misplacement(torus, moved, result.reference_from_mesh), 1e-3);
}

TEST_F(GlobalSearchTest, RigidAndTheSameForAnyNumberOfThreads) {
  const IndexedMesh torus = BumpyTorus(20);
  AlignMeshesOptions options = Options();
  options.estimate_scale = false;
  Similarity3d moved = FarAway(2.2);
  moved.scale = 1;
  const auto run = [&](int threads) {
    return AlignMeshes(
               TransformMesh(torus, moved), torus, options, Context(threads))
        .reference_from_mesh;
  };
  const Similarity3d one = run(1);
  EXPECT_LT(Misplacement(torus, moved, one), 1e-4);
  EXPECT_EQ(one.scale, 1);
  const Similarity3d three = run(3);
  EXPECT_EQ(one.rotation, three.rotation);
  EXPECT_EQ(one.translation, three.translation);
}

TEST_F(GlobalSearchTest, SymmetricShapesAndFailuresAreReported) {
  testing::Recorder sink;
  IndexedMesh brick = Cube(6);
  for (Eigen::Vector3d& p : brick.positions) {
    p = p.cwiseProduct(Eigen::Vector3d(3, 2, 1));
  }
  EXPECT_TRUE(
      AlignMeshes(
          TransformMesh(brick, FarAway(1)), brick, Options(), Context(2, &sink))
          .is_ambiguous);
  EXPECT_THAT(sink.warnings,
              ::testing::ElementsAre(::testing::HasSubstr("symmetric")));
  // Other shapes.
  EXPECT_THAT(
      [&] {
        AlignMeshes(TransformMesh(BumpyTorus(20), FarAway(1)),
                    brick,
                    Options(),
                    Context(2));
      },
      ::testing::ThrowsMessage<InputError>(
          ::testing::HasSubstr("alignment failed: the surfaces stay")));
  testing::Recorder second;
  AlignMeshes(BumpyTorus(20), brick, FewSamples(), Context(2, &second));
  EXPECT_THAT(
      second.warnings,
      ::testing::ElementsAre(::testing::HasSubstr("alignment.global_search")));
}

TEST(AlignMeshes, NoiseDoesNotBiasTheScale) {
  const IndexedMesh reference = Potato(30);
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 0.01);
  const Similarity3d moved = TestSimilarity(0.03, 1.01, 0.01);
  IndexedMesh mesh = TransformMesh(reference, moved);
  for (Eigen::Vector3d& p : mesh.positions) {
    p += Eigen::Vector3d(normal(random), normal(random), normal(random));
  }
  const MeshAlignment result =
      AlignMeshes(mesh, reference, FewSamples(), Context(2));
  EXPECT_NEAR(result.reference_from_mesh.scale * moved.scale, 1, 1e-3);
  // Below the noise, though hardly anything holds its turns.
  EXPECT_LT(Misplacement(reference, moved, result.reference_from_mesh), 7e-3);
}

TEST(AlignMeshes, RigidLeavesTheScale) {
  const IndexedMesh mesh = Potato(20);
  AlignMeshesOptions options = FewSamples();
  options.estimate_scale = false;
  const MeshAlignment result =
      AlignMeshes(TransformMesh(mesh, TestSimilarity(0.05, 1.1, 0.02)),
                  mesh,
                  options,
                  Context(2));
  EXPECT_EQ(result.reference_from_mesh.scale, 1);
  EXPECT_LT(result.rms_after, result.rms_before);
}

TEST(AlignMeshes, ShapesThatLeaveMotionsOpen) {
  // A sphere says nothing of rotations, a plane of three motions and scale.
  const MeshAlignment sphere =
      AlignMeshes(Moved(Sphere(20, 1.03), {0.02, 0, 0.01}),
                  Sphere(20),
                  FewSamples(),
                  Context(2));
  EXPECT_NEAR(sphere.reference_from_mesh.scale, 1 / 1.03, 1e-3);
  EXPECT_LT(sphere.rms_after, 2e-3);
  const IndexedMesh plane = HeightField(4, [](double, double) { return 0; });
  const MeshAlignment flat =
      AlignMeshes(Moved(plane, {0, 0, 0.05}), plane, FewSamples(), Context(2));
  EXPECT_LT(flat.rms_after, 1e-6);
  EXPECT_NEAR(flat.reference_from_mesh.scale, 1, 0.05);
  EXPECT_TRUE(flat.reference_from_mesh.translation.allFinite());
}

TEST(AlignMeshes, AlreadyAlignedStays) {
  const IndexedMesh mesh = Potato(20);
  const MeshAlignment result =
      AlignMeshes(mesh, mesh, FewSamples(), Context(2));
  EXPECT_LT(Misplacement(mesh, Similarity3d(), result.reference_from_mesh),
            1e-9);
  EXPECT_LE(result.rms_after, result.rms_before);
}

TEST(AlignMeshes, SameBytesForAnyNumberOfThreads) {
  const IndexedMesh mesh = Potato(15);
  const IndexedMesh moved =
      TransformMesh(Potato(18), TestSimilarity(0.1, 1.05, 0.02));
  const auto run = [&](int threads) {
    const Similarity3d result =
        AlignMeshes(moved, mesh, FewSamples(), Context(threads))
            .reference_from_mesh;
    return std::tuple(
        result.scale, result.rotation.eval(), result.translation.eval());
  };
  EXPECT_EQ(run(1), run(2));
  EXPECT_EQ(run(1), run(4));
}

TEST(AlignMeshesOptions, Rejections) {
  const auto refusal = [](const auto& change) {
    AlignMeshesOptions options;
    EXPECT_NO_THROW(options.Check());
    change(options);
    try {
      options.Check();
    } catch (const OptionError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using Options = AlignMeshesOptions;
  using ::testing::StartsWith;
  EXPECT_THAT(refusal([](Options& o) { o.num_samples = 0; }),
              StartsWith("alignment.num_samples = 0: must"));
}

}  // namespace
}  // namespace octacut
