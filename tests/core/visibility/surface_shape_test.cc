#include "core/visibility/surface_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/crust/crust.h"
#include "core/views/view_projection.h"
#include "tests/core/crust/labeled_shapes.h"
#include "tests/core/views/random_views.h"

namespace octacut {
namespace {

using testing::Ball;
using testing::OneLevel;

const Eigen::Vector3d kMiddle(0.48, 0.51, 0.5);

Crust CrustOfBall() {
  return RefineCrust(
      OneLevel(Ball(kMiddle, 0.35), 5), CrustOptions(), Context(2));
}

// All voxels of a cube of 16^3 with first <= z < end.
VoxelGrid Slab(int first, int end) {
  std::vector<MortonCode> codes;
  codes.reserve(size_t{256} * size_t(end - first));
  for (int i = 0; i < 16 * 16; ++i) {
    for (int z = first; z < end; ++z) {
      codes.push_back(EncodeMorton(i % 16, i / 16, z));
    }
  }
  return VoxelGrid::FromCodes(4, codes);
}

TEST(EstimateSurfaceShape, PointOutwardOfABall) {
  const Crust crust = CrustOfBall();
  const std::vector<SurfaceShape> shapes = EstimateSurfaceShape(
      crust.voxels, crust.ties, crust.prior, 12, Context(2));
  ASSERT_EQ(shapes.size(), crust.voxels.Size());
  std::vector<double> angles;
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const Eigen::Vector3d center =
        VoxelCenter(DecodeMorton(code), crust.voxels.Level()).cast<double>();
    ASSERT_NEAR(shapes[index].normal.norm(), 1, 1e-4);
    angles.push_back(std::acos(std::min(1.0,
                                        shapes[index].normal.cast<double>().dot(
                                            (center - kMiddle).normalized()))) *
                     180 / std::numbers::pi);
  });
  std::sort(angles.begin(), angles.end());
  EXPECT_LT(angles[angles.size() / 2], 6);
  EXPECT_LT(angles[angles.size() * 95 / 100], 18);
}

TEST(EstimateSurfaceShape, CurvatureOfABallIsThatOfItsRadius) {
  const Crust crust = CrustOfBall();
  const std::vector<SurfaceShape> shapes = EstimateSurfaceShape(
      crust.voxels, crust.ties, crust.prior, 12, Context(2));
  const double radius = 0.35 * crust.voxels.Resolution();
  double sum = 0;
  double squares = 0;
  size_t count = 0;
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const double height =
        (VoxelCenter(DecodeMorton(code), crust.voxels.Level()).cast<double>() -
         kMiddle)
                .norm() *
            crust.voxels.Resolution() -
        radius;
    if (std::abs(height) < 1) {
      sum += shapes[index].curvature;
      squares += std::pow(shapes[index].curvature - 1 / radius, 2);
      ++count;
    }
  });
  ASSERT_GT(count, 1000u);
  EXPECT_NEAR(sum / double(count) * radius, 1, 0.1);
  // Steps of the coarser voxels make it rough.
  EXPECT_LT(std::sqrt(squares / double(count)) * radius, 2);
}

TEST(EstimateSurfaceShape, OfAPlaneAreExact) {
  // A whole slab of the cube: inside below, tied so at both sides.
  const VoxelGrid slab = Slab(5, 11);
  std::vector<FaceTies> ties(slab.Size(), 0);
  std::vector<float> prior(slab.Size());
  slab.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const int z = DecodeMorton(code).z();
    prior[index] = z < 8 ? 1 : 0;
    if (z == 5) {
      ties[index] = InsideTie(4);
    } else if (z == 10) {
      ties[index] = OutsideTie(5);
    }
  });
  const std::vector<SurfaceShape> shapes =
      EstimateSurfaceShape(slab, ties, prior, 4, Context(1));
  // Far from the slab's rim.
  for (int z = 6; z < 10; ++z) {
    const SurfaceShape& shape = shapes[slab.Find(Eigen::Vector3i(8, 8, z))];
    EXPECT_LT((shape.normal - Eigen::Vector3f::UnitZ()).norm(), 1e-3) << z;
    EXPECT_NEAR(shape.curvature, 0, 1e-3) << z;
  }
}

// A leaf, two voxels thick: its sides are flat however near they are.
TEST(EstimateSurfaceShape, OfALeafAreFlat) {
  const VoxelGrid slab = Slab(4, 12);
  std::vector<FaceTies> ties(slab.Size(), 0);
  std::vector<float> prior(slab.Size());
  slab.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const int z = DecodeMorton(code).z();
    prior[index] = z == 7 || z == 8 ? 1 : 0;
  });
  const std::vector<SurfaceShape> shapes =
      EstimateSurfaceShape(slab, ties, prior, 4, Context(1));
  for (int z = 5; z < 11; ++z) {
    const SurfaceShape& shape = shapes[slab.Find(Eigen::Vector3i(8, 8, z))];
    EXPECT_LT(
        (shape.normal - (z < 8 ? -1 : 1) * Eigen::Vector3f::UnitZ()).norm(),
        1e-3)
        << z;
    EXPECT_NEAR(shape.curvature, 0, 1e-3) << z;
  }
}

TEST(EstimateSurfaceShape, AreZeroWithoutAGradient) {
  std::vector<MortonCode> codes;
  for (MortonCode code = 0; code < 512; ++code) {
    codes.push_back(code);
  }
  const VoxelGrid cube = VoxelGrid::FromCodes(3, codes);
  std::vector<FaceTies> ties(cube.Size(), 0);
  cube.ForEach([&](VoxelGrid::Index index, MortonCode) {
    for (int face = 0; face < kNumFaces; ++face) {
      ties[index] |= InsideTie(face);
    }
  });
  for (const SurfaceShape& shape : EstimateSurfaceShape(
           cube, ties, std::vector<float>(cube.Size(), 1), 3, Context(1))) {
    EXPECT_EQ(shape.normal, Eigen::Vector3f::Zero());
    EXPECT_EQ(shape.curvature, 0);
  }
}

TEST(EstimateSurfaceShape, OfSomeVoxelsAreThoseAmongAll) {
  const Crust crust = CrustOfBall();
  // A patch, and single voxels elsewhere.
  std::vector<uint8_t> wanted(crust.voxels.Size(), 0);
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    wanted[index] = DecodeMorton(code).x() < 14 || index % 4001 == 0;
  });
  for (const int blur_steps : {0, 1, 5}) {
    const std::vector<SurfaceShape> all = EstimateSurfaceShape(
        crust.voxels, crust.ties, crust.prior, blur_steps, Context(2));
    std::vector<SurfaceShape> expected;
    for (size_t i = 0; i < all.size(); ++i) {
      if (wanted[i]) {
        expected.push_back(all[i]);
      }
    }
    ASSERT_GT(expected.size(), 100u);
    ASSERT_LT(expected.size(), all.size() / 4);
    for (const int num_threads : {1, 3}) {
      EXPECT_EQ(EstimateSurfaceShape(crust.voxels,
                                     crust.ties,
                                     crust.prior,
                                     blur_steps,
                                     Context(num_threads),
                                     wanted),
                expected);
    }
  }
}

TEST(EstimateSurfaceShape, AreTheSameForAnyNumberOfThreads) {
  const Crust crust = CrustOfBall();
  const auto estimate = [&](int num_threads) {
    return EstimateSurfaceShape(
        crust.voxels, crust.ties, crust.prior, 5, Context(num_threads));
  };
  const std::vector<SurfaceShape> expected = estimate(1);
  EXPECT_EQ(estimate(2), expected);
  EXPECT_EQ(estimate(4), expected);
}

}  // namespace
}  // namespace octacut
