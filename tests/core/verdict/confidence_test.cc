#include "core/verdict/confidence.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::MakeRefineScene;
using testing::RefineScene;

std::vector<float> Confidence(const RefineScene& scene,
                              IndexedMesh mesh,
                              const Context& context = Context(2)) {
  const SurfaceEvidence evidence = MeasureSurfaceEvidence(
      scene.test.views, SurfaceEvidenceOptions(), context, &mesh);
  return VertexConfidence(mesh, evidence, context);
}

// The mean confidence of the vertices whose direction has a z in the given
// range.
float MeanConfidence(const std::vector<float>& confidence,
                     const IndexedMesh& mesh,
                     double from,
                     double to) {
  float sum = 0;
  int count = 0;
  for (size_t v = 0; v < confidence.size(); ++v) {
    const double z = mesh.normals[v].z();
    if (z >= from && z <= to) {
      sum += confidence[v];
      ++count;
    }
  }
  return sum / float(std::max(count, 1));
}

TEST(VertexConfidence, IsHighWherePhotographsDecideAndLowWhereNoneSees) {
  // From above the horizon alone.
  const RefineScene scene = MakeRefineScene(10);
  const IndexedMesh mesh = scene.Larger(24, 0);
  const std::vector<float> confidence = Confidence(scene, mesh);
  ASSERT_EQ(confidence.size(), mesh.positions.size());
  const auto [least, most] =
      std::minmax_element(confidence.begin(), confidence.end());
  EXPECT_GT(*least, 0);
  EXPECT_LT(*most, 1);
  EXPECT_GT(MeanConfidence(confidence, mesh, 0, 0.8), 0.6f);
  EXPECT_LT(MeanConfidence(confidence, mesh, -1, -0.9), 0.35f);
}

TEST(VertexConfidence, IsLowWhereTheSurfaceIsWrong) {
  const RefineScene scene = MakeRefineScene();
  const IndexedMesh right = scene.Larger(24, 0);
  // One side is five pixels too far inside.
  const double depth = 5 * scene.Pixel();
  const IndexedMesh wrong = scene.ToUnitMesh(
      RefineScene::Mesh(24, [&](const Eigen::Vector3d& direction) {
        return -depth * std::clamp(5 * (direction.z() - 0.3), 0.0, 1.0);
      }));
  const std::vector<float> confidence = Confidence(scene, wrong);
  EXPECT_LT(MeanConfidence(confidence, right, 0.7, 0.95),
            0.5f * MeanConfidence(confidence, right, -0.5, 0.1));
}

TEST(VertexConfidence, IsTheSameForAnyNumberOfThreads) {
  const RefineScene scene = MakeRefineScene();
  EXPECT_EQ(Confidence(scene, scene.Larger(16, 1), Context(1)),
            Confidence(scene, scene.Larger(16, 1), Context(2)));
}

// Three points in a row, 4 pixels apart.
SurfaceEvidence ThreePoints(const std::vector<PointEvidence>& values) {
  IndexedMesh triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  SurfaceEvidence evidence{RayScene(triangle), {}, values, 0.01};
  evidence.points.neighbors.offsets = {0, 1, 3, 4};
  evidence.points.neighbors.entries = {1, 0, 2, 1};
  for (size_t i = 0; i < 3; ++i) {
    evidence.values[i].position = Eigen::Vector3f(0.04f * float(i), 0, 0);
  }
  return evidence;
}

TEST(ExpectedErrors, GrowWithWhatIsLeftOpen) {
  PointEvidence exact;
  exact.num_views = 8;
  exact.precision = 8;
  exact.hull_distance = 20;
  PointEvidence seen = exact;
  seen.precision = 0;
  PointEvidence contours = seen;
  contours.hull_distance = 0;
  contours.num_contours = 9;
  contours.curvature = 0.01f;
  PointEvidence contour = contours;
  contour.num_contours = 1;
  PointEvidence hollow = contour;
  hollow.curvature = -0.01f;
  PointEvidence unseen = hollow;
  unseen.num_views = 1;
  const auto error = [](const PointEvidence& point) {
    return ExpectedErrors(ThreePoints({point, point, point}))[1];
  };
  EXPECT_LT(error(exact), 0.2f);
  EXPECT_LT(error(exact), error(contours));
  EXPECT_LT(error(contours), error(contour));
  EXPECT_LT(error(contour), error(hollow));
  EXPECT_LT(error(hollow), error(seen));
  EXPECT_LT(error(hollow), error(unseen));
  // What lies beside an exact point is known better.
  EXPECT_LT(ExpectedErrors(ThreePoints({exact, exact, seen}))[2],
            error(seen) / 2);
}

}  // namespace
}  // namespace octacut
