#include "core/benchmark/synthetic/lighting.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/benchmark/synthetic/objects.h"
#include "core/benchmark/synthetic/polygonize.h"

namespace octacut {
namespace {

IndexedMesh ReferenceOf(const ImplicitShape& shape) {
  PolygonizeOptions options;
  options.resolution = 50;
  return Polygonize(shape, options, Context(2));
}

TEST(BakeVisibility, ASphereIsLitOnOneSide) {
  const IndexedMesh mesh = ReferenceOf(MakeSphere(0.8));
  const RayScene rays(mesh);
  const std::vector<float> visibility =
      BakeVisibility(mesh, rays, {0, 0, 1}, 5, 16, Context(2));
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.normals[i].z() > 0.15) {
      EXPECT_EQ(visibility[i], 1) << mesh.positions[i].transpose();
    } else if (mesh.normals[i].z() < -0.15) {
      EXPECT_EQ(visibility[i], 0) << mesh.positions[i].transpose();
    }
  }
}

TEST(BakeVisibility, AShadowHasASoftBorder) {
  // A ball over a plate, lit from above.
  const IndexedMesh mesh =
      ReferenceOf(Union({Move(MakeBox({1, 1, 0.1}, 0.02), {0, 0, -0.6}),
                         Move(MakeSphere(0.3), {0, 0, 0.4})}));
  const RayScene rays(mesh);
  const auto count_soft = [&](double angular_radius) {
    const std::vector<float> visibility =
        BakeVisibility(mesh, rays, {0, 0, 1}, angular_radius, 32, Context(2));
    int num_soft = 0;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      const Eigen::Vector3d& p = mesh.positions[i];
      if (mesh.normals[i].z() < 0.99 || p.z() > 0) {
        continue;
      }
      const double radius = p.head<2>().norm();
      if (radius < 0.12) {
        EXPECT_EQ(visibility[i], 0);
      } else if (radius > 0.55) {
        EXPECT_EQ(visibility[i], 1);
      }
      num_soft += visibility[i] > 0 && visibility[i] < 1;
    }
    return num_soft;
  };
  EXPECT_EQ(count_soft(0), 0);
  EXPECT_GT(count_soft(8), 20);
}

TEST(BakeOpenness, CavitiesAreDarkerThanWalls) {
  const IndexedMesh mesh = ReferenceOf(MakeObject("cup").shape);
  const RayScene rays(mesh);
  const std::vector<float> openness = BakeOpenness(mesh, rays, 64, Context(2));
  int num_bottom = 0;
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const Eigen::Vector3d& p = mesh.positions[i];
    const double radius = p.head<2>().norm();
    if (radius > 0.649) {
      EXPECT_GT(openness[i], 0.95f);  // outer wall
    } else if (radius < 0.1 && p.z() > -0.5) {
      // The bottom of the cavity sees the mouth, of radius 0.5 at distance 1:
      // sin^2 of its half angle, 0.2.
      EXPECT_NEAR(openness[i], 0.2, 0.1);
      ++num_bottom;
    }
  }
  EXPECT_GT(num_bottom, 5);
}

TEST(LightingOptions, RefusesBadValues) {
  const auto refused = [](auto change) {
    LightingOptions options;
    change(options);
    EXPECT_THROW(options.Check(), OptionError);
  };
  refused([](LightingOptions& o) { o.lights[0].direction.setZero(); });
  refused([](LightingOptions& o) { o.lights[0].angular_radius = 90; });
  refused([](LightingOptions& o) { o.specular = -1; });
  refused([](LightingOptions& o) { o.shininess = 0; });
  refused([](LightingOptions& o) { o.num_samples = 0; });
  EXPECT_NO_THROW(LightingOptions{}.Check());
}

}  // namespace
}  // namespace octacut
