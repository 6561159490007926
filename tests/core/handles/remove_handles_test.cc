#include "core/handles/remove_handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/mesh/untangle.h"
#include "tests/core/extract/label_crust.h"

namespace octacut {
namespace {

constexpr int kLevel = 6;
constexpr double kVoxel = 1.0 / (1 << kLevel);

double DistanceToSegment(const Eigen::Vector3d& point,
                         const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b) {
  const double t =
      std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (point - a - t * (b - a)).norm();
}

IndexedMesh MeshOf(
    const std::function<double(const Eigen::Vector3d&)>& distance) {
  return Place(LabelShape(kLevel, distance), UnitCube());
}

// Two balls, joined by two bars of the given radii.
IndexedMesh JoinedBalls(double first_radius, double second_radius) {
  const Eigen::Vector3d low(0.28, 0.5, 0.5);
  const Eigen::Vector3d high(0.72, 0.5, 0.5);
  return MeshOf([&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d side(0, 0.1, 0);
    return std::min(
        {(p - low).norm() - 0.17,
         (p - high).norm() - 0.17,
         DistanceToSegment(p, low - side, high - side) - first_radius,
         DistanceToSegment(p, low + side, high + side) - second_radius});
  });
}

RemovedHandles Remove(const IndexedMesh& mesh,
                      double max_length,  // voxels
                      const Context& context = Context(2)) {
  return RemoveHandles(mesh,
                       {.max_length = max_length * kVoxel,
                        .min_height = kMinTriangleHeight * kVoxel},
                       context);
}

// Closed, no triangles intersect, and as many handles fewer as the summary
// says.
void ExpectValidWithoutHandles(const RemovedHandles& removed,
                               const MeshAudit& before) {
  const MeshAudit audit = AuditMesh(removed.mesh, Context(1));
  ExpectClosedManifold(audit);
  EXPECT_EQ(audit.num_components, before.num_components);
  EXPECT_EQ(audit.genus, before.genus - int64_t(removed.summary.num_removed));
  EXPECT_EQ(NumIntersections(removed.mesh), 0u);
}

TEST(RemoveHandles, CutsTheThinnerOfTwoBars) {
  const IndexedMesh mesh = JoinedBalls(1.1 * kVoxel, 3 * kVoxel);
  const MeshAudit before = AuditMesh(mesh, Context(1));
  ASSERT_EQ(before.genus, 1);
  const RemovedHandles cut = Remove(mesh, 12);
  EXPECT_EQ(cut.summary.num_removed, 1u);
  ExpectValidWithoutHandles(cut, before);
  // Vertices have moved at the thin bar alone.
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v] != cut.mesh.positions[v]) {
      EXPECT_LT(mesh.positions[v].y(), 0.45);
    }
  }
}

TEST(RemoveHandles, FillsAPinholeThroughAPlate) {
  const IndexedMesh mesh = MeshOf([](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = p - Eigen::Vector3d(0.5, 0.5, 0.5);
    const double plate =
        std::max(std::hypot(q.x(), q.y()) - 0.35, std::abs(q.z()) - 4 * kVoxel);
    return std::max(plate, 1.2 * kVoxel - std::hypot(q.x(), q.y()));
  });
  const MeshAudit before = AuditMesh(mesh, Context(1));
  ASSERT_EQ(before.genus, 1);
  const RemovedHandles filled = Remove(mesh, 12);
  EXPECT_EQ(filled.summary.num_removed, 1u);
  ExpectValidWithoutHandles(filled, before);
  const double volume = AuditMesh(filled.mesh, Context(1)).volume;
  EXPECT_GT(volume, before.volume);
  EXPECT_NEAR(volume, before.volume, 0.01 * before.volume);
}

// Loops of 14 to 17 edges of a voxel go around a bar and a hole of the same
// width.
constexpr double kWideRadius = 2.2 * kVoxel;

IndexedMesh WideBars() { return JoinedBalls(kWideRadius, 3 * kVoxel); }

IndexedMesh PlateWithHole() {
  return MeshOf([&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = p - Eigen::Vector3d(0.5, 0.5, 0.5);
    return std::max({std::hypot(q.x(), q.y()) - 0.35,
                     std::abs(q.z()) - 4 * kVoxel,
                     kWideRadius - std::hypot(q.x(), q.y())});
  });
}

TEST(RemoveHandles, FillsTunnelsTwiceAsWideAsTheBridgesItCuts) {
  const auto num_removed = [&](const IndexedMesh& mesh, double max_length) {
    return Remove(mesh, max_length).summary.num_removed;
  };
  EXPECT_EQ(num_removed(WideBars(), 10), 0u);
  EXPECT_EQ(num_removed(WideBars(), 20), 1u);
  EXPECT_EQ(num_removed(PlateWithHole(), 5), 0u);
  EXPECT_EQ(num_removed(PlateWithHole(), 10), 1u);
}

TEST(RemoveHandles, LoopsMayBeLongerWhereAllOfThemMayBe) {
  const auto num_removed = [&](const IndexedMesh& mesh,
                               double max_length_anywhere,
                               const auto& max_length_at) {
    return RemoveHandles(mesh,
                         {.max_length = 5 * kVoxel,
                          .min_height = kMinTriangleHeight * kVoxel,
                          .max_length_at = max_length_at,
                          .max_length_anywhere = max_length_anywhere * kVoxel},
                         Context(2))
        .summary.num_removed;
  };
  const auto everywhere = [](double voxels) {
    return [=](const Eigen::Vector3d&) { return voxels * kVoxel; };
  };
  const auto in_upper_half = [](const Eigen::Vector3d& p) {
    return p.z() > 0.5 ? 20 * kVoxel : 0;
  };
  for (const IndexedMesh& mesh : {WideBars(), PlateWithHole()}) {
    EXPECT_EQ(num_removed(mesh, 20, everywhere(20)), 1u);
    EXPECT_EQ(num_removed(mesh, 12, everywhere(20)), 0u);
    EXPECT_EQ(num_removed(mesh, 20, everywhere(12)), 0u);
  }
  // Loops around the bar reach below.
  EXPECT_EQ(num_removed(WideBars(), 20, in_upper_half), 0u);
}

TEST(RemoveHandles, LeavesThickHandles) {
  const IndexedMesh mesh = MeshOf(TorusDistance);
  const RemovedHandles same = Remove(mesh, 12);
  EXPECT_EQ(same.summary.num_removed, 0u);
  EXPECT_EQ(same.mesh.positions, mesh.positions);
  EXPECT_EQ(same.mesh.triangles, mesh.triangles);
}

// Noise: many handles, also next to each other and around each other.
TEST(RemoveHandles, KeepsRandomBlocksValid) {
  std::mt19937 random(11);
  size_t num_removed = 0;
  for (int round = 0; round < 100; ++round) {
    const LabelledCrust block = LabelRandomBlock(3 + round % 4, false, random);
    IndexedMesh mesh =
        ExtractSurface(block.crust, block.labels, UnitVoxels(4), Context(1))
            .mesh;
    if (mesh.triangles.empty()) {
      continue;
    }
    const MeshAudit before = AuditMesh(mesh, Context(1));
    const RemovedHandles cut = RemoveHandles(
        mesh, {.max_length = 12, .min_height = kMinTriangleHeight}, Context(1));
    ExpectValidWithoutHandles(cut, before);
    ASSERT_FALSE(HasFailure()) << "round " << round;
    num_removed += cut.summary.num_removed;
    EXPECT_TRUE(int64_t(cut.summary.num_removed) == before.genus ||
                cut.summary.num_refused > 0);
  }
  EXPECT_GT(num_removed, 100u);
}

TEST(RemoveHandles, FillsAHundredPinholesTheSameWithAnyNumberOfThreads) {
  const IndexedMesh mesh = MeshOf([](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = p - Eigen::Vector3d(0.5, 0.5, 0.5);
    const double plate = std::max({std::abs(q.x()) - 0.45,
                                   std::abs(q.y()) - 0.45,
                                   std::abs(q.z()) - 4 * kVoxel});
    const auto from_hole = [](double x) {
      return std::abs(x / 0.08 - std::floor(x / 0.08) - 0.5) * 0.08;
    };
    const bool has_hole = std::max(std::abs(q.x()), std::abs(q.y())) < 0.4;
    return has_hole ? std::max(plate,
                               1.2 * kVoxel - std::hypot(from_hole(q.x()),
                                                         from_hole(q.y())))
                    : plate;
  });
  const MeshAudit before = AuditMesh(mesh, Context(1));
  ASSERT_EQ(before.genus, 100);
  const RemovedHandles filled = Remove(mesh, 12, Context(1));
  EXPECT_EQ(filled.summary.num_removed, 100u);
  ExpectValidWithoutHandles(filled, before);
  const RemovedHandles threaded = Remove(mesh, 12, Context(3));
  EXPECT_EQ(threaded.mesh.positions, filled.mesh.positions);
  EXPECT_EQ(threaded.mesh.triangles, filled.mesh.triangles);
}

// A rod through the pinhole leaves no place for what would fill it.
TEST(RemoveHandles, RefusesWhatWouldIntersect) {
  const IndexedMesh mesh = MeshOf([](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = p - Eigen::Vector3d(0.5, 0.5, 0.5);
    const double radius = std::hypot(q.x(), q.y());
    const double plate = std::max(radius - 0.35, std::abs(q.z()) - 2 * kVoxel);
    const double rod = std::max(radius - 1.5 * kVoxel, std::abs(q.z()) - 0.4);
    return std::min(std::max(plate, 4 * kVoxel - radius), rod);
  });
  const MeshAudit before = AuditMesh(mesh, Context(1));
  ASSERT_EQ(before.genus, 1);
  ASSERT_EQ(before.num_components, 2);
  const RemovedHandles kept = Remove(mesh, 36);
  EXPECT_EQ(kept.summary.num_removed, 0u);
  EXPECT_GT(kept.summary.num_refused, 0u);
  EXPECT_EQ(kept.mesh.positions, mesh.positions);
  EXPECT_EQ(kept.mesh.triangles, mesh.triangles);
}

TEST(RemoveHandles, LeavesAllWhereTheLengthIsNone) {
  const IndexedMesh mesh = JoinedBalls(1.1 * kVoxel, 3 * kVoxel);
  EXPECT_EQ(Remove(mesh, 0).mesh.triangles, mesh.triangles);
}

TEST(RemoveHandles, CanBeCancelled) {
  const IndexedMesh mesh = MeshOf(TorusDistance);
  std::atomic<bool> cancelled = true;
  const Context context(1, nullptr, &cancelled);
  EXPECT_THROW(Remove(mesh, 12, context), CancelledError);
}

}  // namespace
}  // namespace octacut
