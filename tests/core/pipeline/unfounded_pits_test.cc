#include "core/pipeline/unfounded_pits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::RefineScene;

constexpr double kCutVoxel = 0.02;
constexpr double kPitDepth = 4;  // voxels
// The smallest z of directions to the pit; a part of 0.05 of the sphere.
constexpr double kPit = 0.9;

// Points at all vertices of a sphere with a pit at the top, about which the
// views agree by `in_pit`, and by `elsewhere`.
MeasuredSurface Measured(float in_pit, float elsewhere, double depth) {
  MeasuredSurface surface;
  surface.mesh = RefineScene::Mesh(40, [&](const Eigen::Vector3d& direction) {
    return direction.z() > kPit ? -depth * kCutVoxel : 0;
  });
  const size_t n = surface.mesh.positions.size();
  SurfaceAgreement& agreement = surface.agreement;
  agreement.points.vertices = testing::AllVertices(surface.mesh);
  agreement.points.point_of = agreement.points.vertices;
  agreement.points.neighbors = RefineScene::Neighbors(surface.mesh);
  agreement.is_measured.assign(n, 1);
  for (const Eigen::Vector3d& position : surface.mesh.positions) {
    const bool is_pit = position.normalized().z() > kPit;
    agreement.scores.push_back(is_pit ? in_pit : elsewhere);
  }
  return surface;
}

// How many vertices are found; all of them are in the pit.
size_t CountFound(const MeasuredSurface& surface) {
  const IndexedMesh hull =
      RefineScene::Mesh(40, [](const auto&) { return 0.0; });
  const std::vector<uint8_t> found =
      FindUnfoundedPits(surface,
                        surface.agreement.MeansAround(),
                        RayScene(hull),
                        kCutVoxel,
                        Context(2));
  for (size_t v = 0; v < found.size(); ++v) {
    if (found[v]) {
      EXPECT_GT(surface.mesh.positions[v].normalized().z(), kPit);
    }
  }
  return size_t(std::count(found.begin(), found.end(), 1));
}

TEST(FindUnfoundedPits, FindsWhatTheViewsDoNotAgreeAbout) {
  EXPECT_GT(CountFound(Measured(0, 0, kPitDepth)), 200u);
  EXPECT_GT(CountFound(Measured(-0.5f, 0.5f, kPitDepth)), 200u);
}

TEST(FindUnfoundedPits, LeavesHollowsThatPhotographsHaveOpened) {
  EXPECT_EQ(CountFound(Measured(0.2f, 0, kPitDepth)), 0u);
}

TEST(FindUnfoundedPits, LeavesWhatIsNotDeep) {
  EXPECT_EQ(CountFound(Measured(0, 0, 1)), 0u);
}

TEST(FindUnfoundedPits, LeavesWhatNoTwoViewsSee) {
  MeasuredSurface surface = Measured(0, 0, kPitDepth);
  std::fill(surface.agreement.is_measured.begin(),
            surface.agreement.is_measured.end(),
            0);
  EXPECT_EQ(CountFound(surface), 0u);
}

}  // namespace
}  // namespace octacut
