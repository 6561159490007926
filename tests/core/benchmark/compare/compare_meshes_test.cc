#include "core/benchmark/compare/compare_meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "core/base/error.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

CompareMeshesOptions FewComparedSamples(int64_t count = 20000) {
  CompareMeshesOptions options;
  options.num_samples = count;
  return options;
}

MeshComparison Compare(
    const IndexedMesh& mesh,
    const IndexedMesh& reference,
    const CompareMeshesOptions& options = FewComparedSamples()) {
  return CompareMeshes(mesh, reference, options, Context(2));
}

double Flat(double, double) { return 0; }

TEST(CompareMeshes, ParallelPlanes) {
  const double h = 0.01;
  const MeshComparison result = Compare(
      HeightField(7, [&](double, double) { return h; }), HeightField(3, Flat));
  for (const DistanceStatistics& side :
       {result.to_reference, result.from_reference}) {
    EXPECT_EQ(side.num_samples, 20000u);
    EXPECT_NEAR(side.mean, h, 1e-12);
    EXPECT_NEAR(side.rms, h, 1e-12);
    EXPECT_NEAR(side.median, h, 1e-12);
    EXPECT_NEAR(side.percentile_90, h, 1e-12);
    EXPECT_NEAR(side.max, h, 1e-12);
  }
  EXPECT_NEAR(result.reference_diagonal, std::sqrt(2.0), 1e-12);
  // 0.01 is 0.7 % of the diagonal.
  for (const ThresholdScore& score : result.scores) {
    EXPECT_EQ(score.f_score, 0);
  }
  EXPECT_NEAR(result.accuracy, h, 1e-12);
  EXPECT_EQ(result.completeness, 0);
}

// A mesh of which one triangle is a point is no cloud.
TEST(CompareMeshes, ATriangleThatIsAPointChangesNothing) {
  const IndexedMesh plane = HeightField(7, [](double, double) { return 0.01; });
  IndexedMesh with_point = plane;
  with_point.triangles.insert(with_point.triangles.begin(), {4, 4, 4});
  const IndexedMesh ground = HeightField(3, Flat);
  const MeshComparison expected = Compare(plane, ground);
  const MeshComparison result = Compare(with_point, ground);
  EXPECT_EQ(result.to_reference.num_samples, 20000u);
  EXPECT_NEAR(result.to_reference.mean, expected.to_reference.mean, 1e-12);
  EXPECT_NEAR(result.from_reference.max, expected.from_reference.max, 1e-12);
}

TEST(CompareMeshes, TiltedPlaneOverALargeOne) {
  const double h = 0.02;
  IndexedMesh ground = HeightField(1, Flat);
  for (Eigen::Vector3d& p : ground.positions) {
    p = 3 * p - Eigen::Vector3d(1, 1, 0);
  }
  CompareMeshesOptions options = FewComparedSamples();
  const double diagonal = 3 * std::sqrt(2.0);
  options.thresholds = {h / 4 / diagonal, 2 * h / diagonal};
  options.accuracy_fraction = 0.3;
  const MeshComparison result = Compare(
      HeightField(5, [&](double x, double) { return h * x; }), ground, options);
  EXPECT_NEAR(result.to_reference.mean, h / 2, 1e-4 * h);
  EXPECT_NEAR(result.to_reference.rms, h / std::sqrt(3.0), 1e-4 * h);
  EXPECT_NEAR(result.to_reference.median, 0.5 * h, 1e-3 * h);
  EXPECT_NEAR(result.to_reference.percentile_90, 0.9 * h, 1e-3 * h);
  EXPECT_NEAR(result.to_reference.max, h, 1e-12);
  EXPECT_NEAR(result.accuracy, 0.3 * h, 1e-3 * h);
  EXPECT_NEAR(result.scores[0].precision, 0.25, 1e-3);
  EXPECT_NEAR(result.scores[0].distance, h / 4, 1e-12);
  EXPECT_EQ(result.scores[1].precision, 1);
  // The corners of the ground are sqrt(2) from the unit square.
  EXPECT_NEAR(result.from_reference.max, std::sqrt(2.0), 1e-3);
  EXPECT_EQ(result.Hausdorff(), result.from_reference.max);
}

TEST(CompareMeshes, ConcentricSpheres) {
  const MeshComparison result =
      Compare(Sphere(60, 1.02), Sphere(60, 1.0), FewComparedSamples(10000));
  // A chord of the 240-gon lies 1e-4 below its circle.
  for (const DistanceStatistics& side :
       {result.to_reference, result.from_reference}) {
    EXPECT_NEAR(side.mean, 0.02, 2e-4);
    EXPECT_NEAR(side.rms, 0.02, 2e-4);
    EXPECT_NEAR(side.max, 0.02, 5e-4);
  }
  EXPECT_NEAR(result.reference_diagonal, 2 * std::sqrt(3.0), 1e-3);
}

TEST(CompareMeshes, ShiftedCube) {
  const double d = 0.1;
  const MeshComparison result =
      Compare(Moved(Cube(4), {d, 0, 0}), Cube(3), FewComparedSamples(200000));
  // The volume of the six faces: the front one is d away; points of the back
  // one are inside, at the smaller of d and their distance b to the square's
  // border (fraction (1 - 2t)^2 has b > t); the four others reach beyond by up
  // to d.
  const double inner = (1 - std::pow(1 - 2 * d, 3)) / 6;
  const double inner_squares = d * d - 8.0 / 3 * d * d * d + 2 * d * d * d * d;
  const double mean = (d + inner + 4 * d * d / 2) / 6;
  const double rms = std::sqrt((d * d + inner_squares + 4 * d * d * d / 3) / 6);
  for (const DistanceStatistics& side :
       {result.to_reference, result.from_reference}) {
    EXPECT_NEAR(side.mean, mean, 2e-3 * mean);
    EXPECT_NEAR(side.rms, rms, 2e-3 * rms);
    EXPECT_NEAR(side.max, d, 1e-12);
    EXPECT_EQ(side.median, 0);
  }
}

TEST(CompareMeshes, HalfOfTheMeshIsMissing) {
  const IndexedMesh whole = Sphere(40);
  const auto is_upper = [](const Eigen::Vector3d& p) { return p.z() > 0; };
  const IndexedMesh half = KeepTriangles(whole, is_upper);
  const MeshComparison result = Compare(half, whole);
  EXPECT_NEAR(result.to_reference.max, 0, 1e-12);
  for (const ThresholdScore& score : result.scores) {
    EXPECT_EQ(score.precision, 1);
    // Below the equator another threshold's width counts, half of it in area.
    EXPECT_NEAR(score.recall, 0.5 + score.distance / 2, 2e-3);
    EXPECT_NEAR(score.f_score, 2 * score.recall / (1 + score.recall), 1e-12);
  }
  EXPECT_NEAR(result.completeness, result.scores[2].recall, 1e-12);
  EXPECT_NEAR(result.from_reference.max, std::sqrt(2.0), 1e-3);

  const MeshComparison turned = Compare(whole, half);
  EXPECT_EQ(turned.scores[0].recall, 1);
  EXPECT_NEAR(turned.scores[0].precision, result.scores[0].recall, 3e-3);
}

TEST(CompareMeshes, OnlyTheReferenceThatCounts) {
  const IndexedMesh whole = Sphere(40);
  const IndexedMesh half =
      KeepTriangles(whole, [](const Eigen::Vector3d& p) { return p.z() > 0; });
  CompareMeshesOptions options = FewComparedSamples();
  options.reference_filter = [](uint32_t, const Eigen::Vector3d& point) {
    return point.z() > 0.05;
  };
  const MeshComparison result = Compare(half, whole, options);
  EXPECT_EQ(result.scores[0].recall, 1);
  EXPECT_NEAR(result.from_reference.max, 0, 1e-12);
  EXPECT_NEAR(result.from_reference.num_samples, 20000 * 0.475, 40);
  EXPECT_NEAR(result.judged_share, 0.475, 2e-3);
  EXPECT_EQ(Compare(half, whole, FewComparedSamples()).judged_share, 1);
  // A mesh that is wrong only where the reference does not count.
  const IndexedMesh dented =
      Sphere(40, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        return p.z() < -0.1 ? p * 1.2 : p;
      });
  const MeshComparison masked = Compare(dented, whole, options);
  EXPECT_LT(masked.to_reference.num_samples, 11000u);
  EXPECT_NEAR(masked.to_reference.max, 0, 1e-12);
  options.reference_filter = [](uint32_t, const Eigen::Vector3d&) {
    return false;
  };
  EXPECT_THROW(Compare(half, whole, options), InputError);
}

TEST(CompareMeshes, MaximumIncludesVertices) {
  IndexedMesh plane = HeightField(1, Flat);
  const IndexedMesh reference = plane;
  // A needle of nearly no area: no sample hits its point.
  const auto first = static_cast<uint32_t>(plane.positions.size());
  plane.positions.insert(plane.positions.end(),
                         {{0.5, 0.5, 0}, {0.5 + 1e-9, 0.5, 0}, {0.5, 0.5, 1}});
  plane.triangles.push_back({first, first + 1, first + 2});
  // Not part of any triangle.
  plane.positions.emplace_back(0, 0, 77);
  const MeshComparison result = Compare(plane, reference);
  EXPECT_NEAR(result.to_reference.max, 1, 1e-12);
  EXPECT_LT(result.to_reference.mean, 1e-3);
}

// Independent of the raycasting library: the nearest of the foot of the
// perpendicular, if inside, and the nearest points of the edges.
double BruteForceDistance(const Eigen::Vector3d& query,
                          const IndexedMesh& mesh) {
  double best = std::numeric_limits<double>::infinity();
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    std::array<Eigen::Vector3d, 3> corner;
    for (int i = 0; i < 3; ++i) {
      corner[i] = mesh.positions[triangle[i]];
    }
    const Eigen::Vector3d normal =
        (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    const double height = normal.dot(query - corner[0]);
    const Eigen::Vector3d foot = query - height * normal;
    bool is_inside = true;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d& a = corner[i];
      const Eigen::Vector3d edge = corner[(i + 1) % 3] - a;
      is_inside = is_inside && edge.cross(foot - a).dot(normal) >= 0;
      const double t =
          std::clamp((query - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      best = std::min(best, (a + t * edge - query).norm());
    }
    best = is_inside ? std::min(best, std::abs(height)) : best;
  }
  return best;
}

TEST(CompareMeshes, AgainstBruteForceOnTriangleSoups) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto soup = [&](int count) {
    IndexedMesh mesh;
    for (int i = 0; i < 3 * count; ++i) {
      mesh.positions.emplace_back(
          uniform(random), uniform(random), uniform(random));
    }
    for (uint32_t i = 0; i < static_cast<uint32_t>(count); ++i) {
      mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
  };
  for (int trial = 0; trial < 5; ++trial) {
    const IndexedMesh mesh = soup(20);
    const IndexedMesh reference = soup(30);
    // The same areas by brute force: each triangle cut into small ones.
    double sum = 0;
    double area_sum = 0;
    double max = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int n = 24;
      const Eigen::Vector3d u = (mesh.positions[b] - mesh.positions[a]) / n;
      const Eigen::Vector3d v = (mesh.positions[c] - mesh.positions[a]) / n;
      const double area = u.cross(v).norm();
      for (int i = 0; i < n; ++i) {
        for (int j = 0; i + j < n; ++j) {
          for (int half = 0; half < (i + j + 1 < n ? 2 : 1); ++half) {
            const double shift = half == 0 ? 1.0 / 3 : 2.0 / 3;
            sum +=
                area * BruteForceDistance(mesh.positions[a] + (i + shift) * u +
                                              (j + shift) * v,
                                          reference);
            area_sum += area;
          }
        }
      }
      for (const uint32_t vertex : {a, b, c}) {
        max = std::max(max,
                       BruteForceDistance(mesh.positions[vertex], reference));
      }
    }
    const MeshComparison result = Compare(mesh, reference);
    EXPECT_NEAR(result.to_reference.mean, sum / area_sum, 3e-3);
    // The distance to a union is not convex: samples may exceed vertices.
    EXPECT_GE(result.to_reference.max, max - 1e-12);
  }
}

void ExpectSame(const DistanceStatistics& a, const DistanceStatistics& b) {
  EXPECT_EQ(a.num_samples, b.num_samples);
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.rms, b.rms);
  EXPECT_EQ(a.median, b.median);
  EXPECT_EQ(a.percentile_90, b.percentile_90);
  EXPECT_EQ(a.max, b.max);
}

TEST(CompareMeshes, SameBytesForAnyNumberOfThreads) {
  CompareMeshesOptions options = FewComparedSamples();
  options.align = true;
  options.alignment.num_samples = 2000;
  const IndexedMesh mesh = Moved(Potato(15), {0.01, 0.02, -0.01});
  const IndexedMesh reference = Potato(20);
  const MeshComparison one =
      CompareMeshes(mesh, reference, options, Context(1));
  for (const int threads : {2, 4}) {
    const MeshComparison other =
        CompareMeshes(mesh, reference, options, Context(threads));
    ExpectSame(one.to_reference, other.to_reference);
    ExpectSame(one.from_reference, other.from_reference);
    EXPECT_EQ(one.accuracy, other.accuracy);
    EXPECT_EQ(one.completeness, other.completeness);
    EXPECT_EQ(one.alignment->reference_from_mesh.translation,
              other.alignment->reference_from_mesh.translation);
    EXPECT_EQ(one.alignment->rms_after, other.alignment->rms_after);
  }
  const MeshComparison seeded =
      CompareMeshes(mesh, reference, options, Context(1, nullptr, nullptr, 8));
  EXPECT_NE(one.to_reference.mean, seeded.to_reference.mean);
  EXPECT_NEAR(one.to_reference.mean, seeded.to_reference.mean, 2e-4);
}

TEST(CompareMeshes, AligningFirstRemovesASimilarity) {
  Similarity3d moved;
  moved.scale = 1.02;
  moved.rotation =
      Eigen::AngleAxisd(0.03, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
  moved.translation = {0.01, -0.02, 0.005};
  const IndexedMesh reference = Potato(20);
  CompareMeshesOptions options = FewComparedSamples();
  const IndexedMesh mesh = TransformMesh(reference, moved);
  EXPECT_GT(Compare(mesh, reference, options).to_reference.mean, 0.01);
  options.align = true;
  const MeshComparison result = Compare(mesh, reference, options);
  EXPECT_LT(result.to_reference.max, 1e-6);
  EXPECT_LT(result.from_reference.max, 1e-6);
  EXPECT_NEAR(result.alignment->reference_from_mesh.scale, 1 / 1.02, 1e-6);
}

TEST(CompareMeshes, RefusesWhatHasNoSurface) {
  IndexedMesh points;
  points.positions = {{0, 0, 0}, {1, 1, 1}};
  // A cloud is no surface, but it has distances.
  EXPECT_EQ(Compare(points, Cube(1)).to_reference.max, 0);
  EXPECT_THAT(
      [&] { Compare({}, Cube(1)); },
      ThrowsMessage<InputError>(HasSubstr("neither triangles nor points")));
  EXPECT_THAT([&] { Compare(Cube(1), {}); },
              ThrowsMessage<InputError>(HasSubstr("reference")));
  IndexedMesh line = points;
  line.triangles = {{0, 1, 1}};
  EXPECT_THROW(Compare(line, Cube(1)), InputError);
  IndexedMesh broken = Cube(1);
  broken.triangles[0][1] = 1000;
  EXPECT_THROW(Compare(broken, Cube(1)), InputError);
}

TEST(CompareMeshesOptions, DefaultsAndRejections) {
  CompareMeshesOptions options;
  EXPECT_NO_THROW(options.Check());
  EXPECT_EQ(options.num_samples, 500000);
  EXPECT_EQ(options.thresholds, (std::vector<double>{0.001, 0.002, 0.005}));
  EXPECT_FALSE(options.align);
  const auto refused = [](const auto& change) {
    CompareMeshesOptions changed;
    change(changed);
    return [changed] { changed.Check(); };
  };
  using Options = CompareMeshesOptions;
  EXPECT_THAT(refused([](Options& o) { o.num_samples = 9; }),
              ThrowsMessage<OptionError>(HasSubstr("num_samples = 9")));
  EXPECT_THAT(refused([](Options& o) {
                o.thresholds = {0.1, 0};
              }),
              ThrowsMessage<OptionError>(HasSubstr("thresholds = 0")));
  EXPECT_THAT(refused([](Options& o) { o.thresholds.clear(); }),
              ThrowsMessage<OptionError>(HasSubstr("thresholds")));
  EXPECT_THAT(refused([](Options& o) { o.accuracy_fraction = 1.5; }),
              ThrowsMessage<OptionError>(HasSubstr("accuracy_fraction = 1.5")));
  EXPECT_THAT(refused([](Options& o) { o.completeness_threshold = 0; }),
              ThrowsMessage<OptionError>(HasSubstr("completeness_threshold")));
  EXPECT_THAT(refused([](Options& o) {
                o.align = true;
                o.alignment.num_samples = 0;
              }),
              ThrowsMessage<OptionError>(HasSubstr("num_samples = 0")));
}

}  // namespace
}  // namespace octacut
