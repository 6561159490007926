#include "core/benchmark/compare/align_meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
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

TEST(AlignMeshes, MissingPartsAreTrimmed) {
  const IndexedMesh whole = Potato(24);
  const IndexedMesh partial = KeepTriangles(
      whole, [](const Eigen::Vector3d& p) { return p.z() > -0.35; });
  const Similarity3d moved = TestSimilarity(0.05, 1.02, 0.02);
  AlignMeshesOptions options = FewSamples();
  options.kept_fraction = 0.7;
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
  using testing::StartsWith;
  EXPECT_THAT(refusal([](Options& o) { o.num_samples = 0; }),
              StartsWith("alignment.num_samples = 0: must"));
  EXPECT_THAT(refusal([](Options& o) { o.max_iterations = 0; }),
              StartsWith("alignment.max_iterations = 0: must"));
  EXPECT_THAT(refusal([](Options& o) { o.kept_fraction = 1.5; }),
              StartsWith("alignment.kept_fraction = 1.5: must"));
  EXPECT_THAT(refusal([](Options& o) { o.tolerance = -1; }),
              StartsWith("alignment.tolerance = -1: must"));
}

}  // namespace
}  // namespace octacut
