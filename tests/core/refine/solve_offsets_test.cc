#include "core/refine/solve_offsets.h"

#include <gtest/gtest.h>

#include <atomic>

#include "core/base/error.h"
#include "core/refine/neighbor_planes.h"
#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::Random;

// The vertices of a sphere as points that may move along its normals, nothing
// measured.
struct SphereProblem {
  IndexedMesh mesh = Sphere(16, 20);
  VertexCorners neighbors = testing::RefineScene::Neighbors(mesh);
  OffsetProblem problem;

  SphereProblem() {
    const size_t count = mesh.positions.size();
    problem.is_free.assign(count, 1);
    problem.targets.assign(count, 0);
    problem.weights.assign(count, 0);
    for (const Eigen::Vector3d& position : mesh.positions) {
      problem.normals.push_back(position.normalized().cast<float>());
    }
    IndexedMesh with_normals = mesh;
    with_normals.normals = problem.normals;
    const NeighborPlanes planes = FitNeighborPlanes(
        FitLocalSurfaces(
            with_normals, neighbors, testing::AllVertices(mesh), 4, Context(1)),
        neighbors);
    problem.shares = planes.shares;
    problem.spacings = planes.spacings;
  }
  std::vector<double> Solve(const Context& context = Context(2)) const {
    return SolveOffsets(
        problem, neighbors, {.smoothness = 4, .outlier_scale = 1}, context);
  }
};

TEST(SolveOffsets, LeavesASurfaceAloneThatNothingIsKnownOf) {
  SphereProblem sphere;
  // Targets without weight are none.
  sphere.problem.targets.assign(sphere.problem.targets.size(), 1);
  for (const double offset : sphere.Solve()) {
    EXPECT_NEAR(offset, 0, 1e-4);
  }
}

TEST(SolveOffsets, FollowsTargetsSmoothlyAndNotOutliers) {
  SphereProblem sphere;
  Random random(2);
  const auto truth = [&](size_t v) {
    return 0.8 + 0.5 * sphere.problem.normals[v].x();
  };
  for (size_t v = 0; v < sphere.mesh.positions.size(); ++v) {
    // A third has none, one in ten is wild, the others are noisy.
    if (random.Integer(0, 2) > 0) {
      sphere.problem.weights[v] = 4;
      sphere.problem.targets[v] = float(
          random.Integer(0, 9) == 0 ? random.Uniform(-8, 8)
                                    : truth(v) + random.Uniform(-0.2, 0.2));
    }
  }
  const std::vector<double> offsets = sphere.Solve();
  double error = 0;
  for (size_t v = 0; v < offsets.size(); ++v) {
    error += std::abs(offsets[v] - truth(v));
  }
  EXPECT_LT(error / double(offsets.size()), 0.1);
}

TEST(SolveOffsets, MovesNoVertexThatStays) {
  SphereProblem sphere;
  for (size_t v = 0; v < sphere.mesh.positions.size(); ++v) {
    sphere.problem.targets[v] = 1;
    sphere.problem.weights[v] = 1;
    sphere.problem.is_free[v] = sphere.mesh.positions[v].z() > 0;
  }
  const std::vector<double> offsets = sphere.Solve();
  for (size_t v = 0; v < offsets.size(); ++v) {
    if (!sphere.problem.is_free[v]) {
      EXPECT_EQ(offsets[v], 0);
    } else if (sphere.mesh.positions[v].z() > 10) {
      EXPECT_NEAR(offsets[v], 1, 0.1);
    }
  }
  sphere.problem.is_free.assign(offsets.size(), 0);
  EXPECT_EQ(sphere.Solve(), std::vector<double>(offsets.size(), 0));
}

TEST(SolveOffsets, PullsPointsOfEdges) {
  SphereProblem sphere;
  for (uint32_t a = 0; a < sphere.mesh.positions.size(); ++a) {
    for (const uint32_t b : sphere.neighbors.Of(a)) {
      sphere.problem.edge_targets.push_back({{a, b}, 0.25f, -0.5f, 1});
    }
  }
  for (const double offset : sphere.Solve()) {
    EXPECT_NEAR(offset, -0.5, 0.05);
  }
}

TEST(SolveOffsets, CanBeCancelled) {
  const std::atomic<bool> stop{true};
  EXPECT_THROW(SphereProblem().Solve(Context(1, nullptr, &stop)),
               CancelledError);
}

}  // namespace
}  // namespace octacut
