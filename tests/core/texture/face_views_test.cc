#include "core/texture/face_views.h"

#include <gtest/gtest.h>

#include "tests/core/texture/small_sphere.h"

namespace octacut {
namespace {

using testing::AllAround;
using testing::PhotographsOf;
using testing::SmallSphere;

constexpr int kPhotographSize = 160;

Eigen::Vector3d CenterOf(const IndexedMesh& mesh, size_t f) {
  const auto& [a, b, c] = mesh.triangles[f];
  return (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
}

// A square plate between the first camera, at (4, 0, 0), and the sphere.
void AddPlate(IndexedMesh* mesh) {
  const auto first = uint32_t(mesh->positions.size());
  for (const double y : {-0.3, 0.3}) {
    for (const double z : {-0.3, 0.3}) {
      mesh->positions.emplace_back(2, y, z);
    }
  }
  mesh->triangles.push_back({first, first + 2, first + 1});
  mesh->triangles.push_back({first + 1, first + 2, first + 3});
}

TEST(FindFaceViews, NothingIsSeenThroughWhatIsInFront) {
  IndexedMesh mesh = SmallSphere(4);
  const size_t num_of_sphere = mesh.triangles.size();
  AddPlate(&mesh);
  const FaceViews views =
      FindFaceViews(mesh,
                    RayScene(mesh),
                    PhotographsOf(AllAround(), kPhotographSize),
                    Context(1));
  size_t num_hidden = 0;
  size_t num_beside = 0;
  for (size_t f = 0; f < num_of_sphere; ++f) {
    const Eigen::Vector3d center = CenterOf(mesh, f);
    // The plate's shadow ends at 0.45.
    const double aside = std::max(std::abs(center.y()), std::abs(center.z()));
    if (center.x() > 0.5 && aside < 0.35) {
      ++num_hidden;
      EXPECT_EQ(views.Find(f, 0), nullptr);
    } else if (center.x() > 0.6 && aside > 0.65) {
      ++num_beside;
      EXPECT_NE(views.Find(f, 0), nullptr);
    }
  }
  EXPECT_GT(num_hidden, 20u);
  EXPECT_GT(num_beside, 20u);
}

TEST(FindFaceViews, ViewsBesideAnOccludingContourAreNotSure) {
  IndexedMesh mesh = SmallSphere(4);
  const size_t num_of_sphere = mesh.triangles.size();
  AddPlate(&mesh);
  // From the first camera alone, so that unsure views stay.
  const FaceViews views =
      FindFaceViews(mesh,
                    RayScene(mesh),
                    PhotographsOf({Eigen::Vector3d::UnitX()}, kPhotographSize),
                    Context(1));
  size_t num_near = 0;
  size_t num_far = 0;
  for (size_t f = 0; f < num_of_sphere; ++f) {
    const Eigen::Vector3d center = CenterOf(mesh, f);
    const FaceView* view = views.Find(f, 0);
    if (view == nullptr || center.x() < 0.6) {
      continue;
    }
    // The plate's edge is seen 38.4 pixels from the middle.
    const double pixels = 256 *
                          std::max(std::abs(center.y()), std::abs(center.z())) /
                          (4 - center.x());
    if (pixels < 39.5) {
      ++num_near;
      EXPECT_FALSE(view->is_sure);
    } else if (pixels > 46) {
      ++num_far;
      EXPECT_TRUE(view->is_sure);
    }
  }
  EXPECT_GT(num_near, 0u);
  EXPECT_GT(num_far, 20u);
}

// Of a wide board before the lower half of the picture, the upper edge begins
// and ends outside of the frame. It is 1.5 pixels below the lowest triangles
// that are in sight, which are 8.4 pixels high.
TEST(FindFaceViews, ContoursThatCrossTheFrameCount) {
  const Photographs photographs =
      PhotographsOf({Eigen::Vector3d::UnitX()}, kPhotographSize);
  const Rigid3d world_from_cam = photographs.poses[0].cam_from_world.Inverse();
  const IndexedMesh sphere = SmallSphere(4);
  IndexedMesh mesh = sphere;
  const auto first = uint32_t(mesh.positions.size());
  for (const double y : {0.012, 9.0}) {
    for (const double x : {-9.0, 9.0}) {
      mesh.positions.push_back(world_from_cam * Eigen::Vector3d(x, y, 2));
    }
  }
  mesh.triangles.push_back({first, first + 2, first + 1});
  mesh.triangles.push_back({first + 1, first + 2, first + 3});
  const FaceViews views =
      FindFaceViews(mesh, RayScene(mesh), photographs, Context(1));
  size_t num_near = 0;
  size_t num_far = 0;
  for (size_t f = 0; f < sphere.triangles.size(); ++f) {
    const Eigen::Vector3d center =
        photographs.poses[0].cam_from_world * CenterOf(mesh, f);
    const FaceView* view = views.Find(f, 0);
    if (view == nullptr || center.z() > 3.4) {
      continue;
    }
    const double pixels = -256 * center.y() / center.z();
    if (pixels < 7) {
      ++num_near;
      EXPECT_FALSE(view->is_sure);
    } else if (pixels > 9) {
      ++num_far;
      EXPECT_TRUE(view->is_sure);
    }
  }
  EXPECT_GT(num_near, 0u);
  EXPECT_GT(num_far, 20u);
}

}  // namespace
}  // namespace octacut
