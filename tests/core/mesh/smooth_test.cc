#include "core/mesh/smooth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/extract/position_vertices.h"
#include "tests/core/extract/label_crust.h"
#include "tests/core/mesh/simple_meshes.h"

namespace octacut {
namespace {

IndexedMesh ShapeMesh(int level, double (*distance)(const Eigen::Vector3d&)) {
  return Place(LabelShape(level, distance), UnitCube());
}

TEST(SmoothSurface, OneIterationIsTheUmbrellaOperator) {
  // The neighbours of every vertex of an octahedron average to the centre.
  SmoothOptions options;
  options.iterations = 1;
  options.max_displacement = 10;
  const IndexedMesh mesh = MakeOctahedron();
  ASSERT_EQ(AuditMesh(mesh, Context(1)).DescribeFailure(), "");
  const IndexedMesh half = SmoothSurface(mesh, 1, options, Context(1));
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_TRUE(half.positions[v].isApprox(mesh.positions[v] / 2));
  }

  options.max_displacement = 0.125;  // in voxels of 2
  const IndexedMesh bounded = SmoothSurface(mesh, 2, options, Context(1));
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_TRUE(bounded.positions[v].isApprox(mesh.positions[v] * 0.75));
  }

  options.iterations = 0;
  EXPECT_EQ(SmoothSurface(mesh, 1, options, Context(1)).positions,
            mesh.positions);
}

TEST(SmoothSurface, TaubinGivesBackWhatSmoothingTook) {
  SmoothOptions options;
  options.iterations = 1;
  options.max_displacement = 10;
  options.taubin_mu = -1;
  // 1/2 of it, then 2 times that.
  const IndexedMesh mesh = MakeOctahedron();
  const IndexedMesh same = SmoothSurface(mesh, 1, options, Context(1));
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_TRUE(same.positions[v].isApprox(mesh.positions[v]));
  }
}

TEST(SmoothSurface, KeepsTheBoundAndTheAuditOnRandomBlocks) {
  std::mt19937 random(5);
  size_t num_bounded = 0;
  for (int round = 0; round < 400; ++round) {
    const LabelledCrust block =
        LabelRandomBlock(2 + round % 4, round % 2 != 0, random);
    const IndexedMesh positioned = Place(block, UnitVoxels(4));
    if (positioned.triangles.empty()) {
      continue;
    }
    SmoothOptions options;
    options.iterations = 1 + round % 40;
    options.max_displacement = round % 3 == 0 ? 0.3 : 1;
    options.taubin_mu = round % 5 == 0 ? -0.53 : 0;
    const IndexedMesh smooth =
        SmoothSurface(positioned, 1, options, Context(1));
    for (size_t v = 0; v < smooth.positions.size(); ++v) {
      const double displacement =
          (smooth.positions[v] - positioned.positions[v]).norm();
      EXPECT_LE(displacement, options.max_displacement * (1 + 1e-12));
      num_bounded += displacement >= options.max_displacement * (1 - 1e-9);
    }
    EXPECT_EQ(NumIntersections(smooth), 0u);
    ExpectClosedManifold(AuditMesh(smooth, Context(1)));
  }
  EXPECT_GT(num_bounded, 100);
}

struct Exact {
  double (*distance)(const Eigen::Vector3d&);
  double area;
  double volume;
  int64_t genus;
};

const Exact kSphere = {
    SphereDistance, 4 * M_PI * 0.16, 4.0 / 3 * M_PI * 0.064, 0};
const Exact kTorus = {TorusDistance,
                      4 * M_PI* M_PI * 0.27 * 0.12,
                      2 * M_PI* M_PI * 0.27 * 0.0144,
                      1};

TEST(SmoothSurface, SphereAndTorusConverge) {
  for (const Exact& shape : {kSphere, kTorus}) {
    double last_area_error = 1;
    double last_volume_error = 1;
    for (const int level : {4, 5, 6, 7}) {
      SCOPED_TRACE(testing::Message()
                   << "genus " << shape.genus << " level " << level);
      const double voxel = 1.0 / (1 << level);
      const IndexedMesh smooth = SmoothSurface(
          ShapeMesh(level, shape.distance), voxel, SmoothOptions(), Context(1));
      const MeshAudit audit = AuditMesh(smooth, Context(1));
      EXPECT_EQ(audit.DescribeFailure(), "");
      EXPECT_EQ(audit.num_components, 1);
      EXPECT_EQ(audit.genus, shape.genus);
      const double area_error = std::abs(audit.area / shape.area - 1);
      const double volume_error = std::abs(audit.volume / shape.volume - 1);
      // Smoothing takes h^2 / r, where r is the smallest radius of curvature.
      EXPECT_LT(volume_error, last_volume_error / 2);
      EXPECT_LT(area_error, std::max(last_area_error, 0.005));
      last_area_error = area_error;
      last_volume_error = volume_error;
    }
    EXPECT_LT(last_area_error, 0.005);
    EXPECT_LT(last_volume_error, 0.01);
  }
}

TEST(SmoothSurface, SmoothsNormals) {
  // Mean angle between triangles and the sphere.
  const double voxel = 1.0 / 64;
  const IndexedMesh positioned = ShapeMesh(6, SphereDistance);
  const auto mean_angle = [](const IndexedMesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
      const Eigen::Vector3d& a = mesh.positions[t[0]];
      const Eigen::Vector3d normal =
          (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
      const Eigen::Vector3d outward = a - Eigen::Vector3d(0.503, 0.499, 0.501);
      sum += std::acos(
          std::min(1.0, normal.normalized().dot(outward.normalized())));
    }
    return sum / double(mesh.triangles.size()) * 180 / M_PI;
  };
  const double before = mean_angle(positioned);
  const double after =
      mean_angle(SmoothSurface(positioned, voxel, SmoothOptions(), Context(1)));
  EXPECT_LT(after, before / 3);
  EXPECT_LT(after, 4);
}

TEST(SmoothSurface, TaubinKeepsTheVolume) {
  SmoothOptions options;
  options.iterations = 20;
  options.taubin_mu = -0.52;
  const IndexedMesh smooth =
      SmoothSurface(ShapeMesh(6, TorusDistance), 1.0 / 64, options, Context(1));
  EXPECT_NEAR(AuditMesh(smooth, Context(1)).volume / kTorus.volume, 1, 0.005);
}

TEST(SmoothSurface, SameBytesForAnyNumberOfThreads) {
  const IndexedMesh positioned = ShapeMesh(7, TorusDistance);
  const IndexedMesh expected =
      SmoothSurface(positioned, 1.0 / 128, SmoothOptions(), Context(1));
  for (const int num_threads : {2, 4}) {
    EXPECT_EQ(SmoothSurface(
                  positioned, 1.0 / 128, SmoothOptions(), Context(num_threads))
                  .positions,
              expected.positions);
  }
}

TEST(SmoothOptions, RefusesBadValues) {
  EXPECT_NO_THROW(SmoothOptions().Check());
  const auto refuses = [](auto&& change) {
    SmoothOptions options;
    change(options);
    EXPECT_THROW(options.Check(), OptionError);
  };
  refuses([](SmoothOptions& o) { o.iterations = -1; });
  refuses([](SmoothOptions& o) { o.taubin_mu = 0.5; });
  refuses([](SmoothOptions& o) { o.taubin_mu = -0.4; });
  refuses([](SmoothOptions& o) { o.max_displacement = -1; });
  refuses([](SmoothOptions& o) { o.max_displacement = INFINITY; });
  EXPECT_THROW(SmoothSurface(MakeBox(), 0, SmoothOptions(), Context(1)),
               OptionError);
}

}  // namespace
}  // namespace octacut
