#include "core/refine/refine_surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "core/mesh/self_intersections.h"
#include "core/mesh/untangle.h"
#include "core/mesh/vertex_corners.h"
#include "core/refine/refine_round.h"
#include "tests/core/base/stopper.h"
#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::Bumps;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::RefineScene;
using testing::Stopper;

// A mesh with edges of about one and a half pixels that is up to two pixels
// off.
IndexedMesh BumpyMesh(const RefineScene& scene) {
  return RefineScene::Mesh(32, Bumps(2 * scene.Pixel()));
}

RefinedSurface RefineMesh(
    IndexedMesh mesh,
    const RefineScene& scene,
    const Context& context,
    int alignment_steps = RefineOptions().alignment_steps) {
  RefineOptions options;
  options.coarse_rounds = 1;
  options.alignment_steps = alignment_steps;
  ViewSet views = scene.test.views;
  return RefineSurface(
      std::move(mesh), scene.test.region.cube, options, context, &views);
}

RefinedSurface Refine(const RefineScene& scene,
                      const Context& context = Context(2),
                      int alignment_steps = RefineOptions().alignment_steps) {
  return RefineMesh(BumpyMesh(scene), scene, context, alignment_steps);
}

TEST(RefineSurface, FindsTheSurfaceBelowPixelSize) {
  const RefineScene scene = testing::MakeRefineScene();
  const IndexedMesh before = BumpyMesh(scene);
  const RefinedSurface refined = Refine(scene);
  ASSERT_GT(RefineScene::MeanError(before), 0.4 * scene.Pixel());
  EXPECT_LT(RefineScene::MeanError(refined.mesh),
            RefineScene::MeanError(before) / 5);
  EXPECT_EQ(refined.mesh.triangles, before.triangles);
  EXPECT_EQ(refined.mesh.normals.size(), before.positions.size());
  EXPECT_EQ(AuditMesh(refined.mesh, Context(1)).DescribeFailure(), "");
  EXPECT_EQ(FindSelfIntersections(refined.mesh, Context(2)).num_pairs, 0u);
  const RefineSummary& summary = refined.summary;
  EXPECT_EQ(summary.num_vertices, before.positions.size());
  EXPECT_GT(summary.num_moved, summary.num_vertices / 2);
  EXPECT_NEAR(summary.pixel_size, scene.Pixel(), 0.1 * scene.Pixel());
  EXPECT_GT(summary.agreement_after, summary.agreement_before);
  EXPECT_GT(summary.mean_displacement, 0.3);
  EXPECT_GE(summary.max_displacement, summary.mean_displacement);
  // Smaller pieces gain nothing on a sphere, so that one pass is all.
  ASSERT_EQ(summary.rounds.size(), 5u);
  EXPECT_EQ(summary.rounds[0].scale, 2);
  EXPECT_EQ(summary.rounds[1].scale, 2);
  EXPECT_EQ(summary.rounds[2].scale, 1);
  EXPECT_EQ(summary.rounds[2].num_seen, summary.rounds[2].num_points);
  EXPECT_GT(summary.rounds[2].num_measured, summary.rounds[2].num_points / 2);
}

TEST(RefineSurface, AlignsPosesThatAreOff) {
  const RefineScene scene = testing::MakeSceneWithPosesOff(0.5);
  const RefinedSurface refined = Refine(scene);
  EXPECT_LT(RefineScene::MeanError(refined.mesh),
            0.6 * RefineScene::MeanError(Refine(scene, Context(2), 0).mesh));
  // Only when the first round has taken the steps of the voxels, and not where
  // smaller pieces follow noise.
  std::vector<size_t> num_aligned;
  for (const RoundSummary& round : refined.summary.rounds) {
    num_aligned.push_back(round.num_aligned);
  }
  EXPECT_THAT(num_aligned, ElementsAre(0, 28, 28, 28, 0));
}

TEST(RefineSurface, LeavesPosesAloneWherePhotographsAgreeByChance) {
  const RefinedSurface refined = Refine(testing::MakeMetalScene());
  ASSERT_FALSE(refined.summary.rounds.front().KnowsMost());
  for (const RoundSummary& round : refined.summary.rounds) {
    EXPECT_EQ(round.num_aligned, 0u);
  }
  EXPECT_EQ(refined.summary.view_motion.max, 0);
}

TEST(RefineSurface, FindsOutThatMasksAreTooLargeOrTooSmall) {
  const double exact =
      RefineScene::MeanError(Refine(testing::MakeRefineScene()).mesh);
  for (const int offset : {-2, 2}) {
    const RefinedSurface refined =
        Refine(testing::MakeSceneWithMasksOff(offset));
    EXPECT_NEAR(refined.summary.border_shift, offset, 0.5);
    EXPECT_LT(RefineScene::MeanError(refined.mesh), 1.5 * exact);
  }
}

RoundSummary RunRound(const RefineScene& scene,
                      const RoundPlan& plan,
                      IndexedMesh* mesh) {
  const RefineOptions options;
  const double pixel = scene.Pixel() / scene.test.region.cube.edge;
  const VertexCorners neighbors = RefineScene::Neighbors(*mesh);
  const std::vector<Eigen::Vector3d> start = mesh->positions;
  ViewSet views = scene.test.views;
  const SurfaceAgreement agreement =
      MeasureAgreement({views, neighbors, options, pixel}, Context(2), mesh);
  return RefineOnce({start, neighbors, pixel, options},
                    plan,
                    &agreement,
                    Context(2),
                    &views,
                    mesh);
}

// What is taken for the shift of the masks' borders after one round over masks
// that are 2 pixels too large, where so many were known before.
double BorderShiftAfter(double scale,
                        double known,
                        double edge_shift = 0,
                        double edge_shift_slack = 9) {
  const RefineScene scene = testing::MakeSceneWithMasksOff(2);
  IndexedMesh mesh = scene.ToUnitMesh(BumpyMesh(scene));
  return RunRound(scene,
                  {.scale = scale,
                   .range = 3,
                   .smooths = true,
                   .aligns = false,
                   .border_shift = known,
                   .edge_shift = edge_shift,
                   .edge_shift_slack = edge_shift_slack},
                  &mesh)
      .border_shift;
}

// Pixels by which the last round lets vertices leave the masks.
double HullToleranceOf(ViewSet views, const RefineScene& scene) {
  RefineOptions options;
  options.coarse_rounds = 1;
  return RefineSurface(BumpyMesh(scene),
                       scene.test.region.cube,
                       options,
                       Context(2),
                       &views)
      .summary.rounds.back()
      .hull_tolerance;
}

TEST(RefineSurface, LetsVerticesLeaveMasksThatContradictOneAnother) {
  const RefineScene exact = testing::MakeRefineScene();
  EXPECT_EQ(HullToleranceOf(exact.test.views, exact), 0.25);
  // Every second mask is 2 pixels larger than the others.
  const RefineScene larger = testing::MakeSceneWithMasksOff(2);
  ViewSet views = exact.test.views;
  for (size_t i = 0; i < views.size(); i += 2) {
    views[i].silhouette = larger.test.views[i].silhouette;
  }
  EXPECT_GT(HullToleranceOf(views, exact), 1);
}

TEST(RefineOnce, MeasuresBordersWherePixelsAreSmall) {
  EXPECT_NEAR(BorderShiftAfter(2, 0), 2, 0.5);
  EXPECT_NEAR(BorderShiftAfter(2, 0.7), 2, 0.5);
  EXPECT_EQ(BorderShiftAfter(4, 0.7), 0.7);
}

TEST(RefineOnce, LeavesBordersThatAreKnown) {
  EXPECT_EQ(BorderShiftAfter(2, 0, 0, 0), 0);
}

TEST(RefineOnce, StartsFromTheEdgesOfThePhotographs) {
  EXPECT_NEAR(BorderShiftAfter(2, 0.8, 0.8), 2, 0.5);
  // Not beyond what they leave open.
  EXPECT_NEAR(BorderShiftAfter(2, 0.8, 0.8, 0.4), 1.2, 1e-6);
}

// Files keep floats; a mesh that is only valid in doubles may cross itself
// there.
TEST(RefineSurface, MovesVerticesToFloats) {
  const RefineScene scene = testing::MakeRefineScene();
  const IndexedMesh before = BumpyMesh(scene);
  const IndexedMesh refined = Refine(scene).mesh;
  size_t num_moved = 0;
  for (size_t v = 0; v < before.positions.size(); ++v) {
    if (refined.positions[v] != before.positions[v]) {
      EXPECT_EQ(refined.positions[v], RoundedToFloats(refined.positions[v]));
      ++num_moved;
    }
  }
  EXPECT_GT(num_moved, before.positions.size() / 2);
}

// How rough a mesh is that had steps, after a round of twice its pixels.
double RoughnessAfter(const RefineScene& scene, bool smooths) {
  IndexedMesh mesh = BumpyMesh(scene);
  const double step = 0.2 * scene.Pixel();
  const BoundingCube& cube = scene.test.region.cube;
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v] +=
        (v % 2 == 0 ? step : -step) * mesh.positions[v].normalized();
    mesh.positions[v] = (mesh.positions[v] - cube.min_corner) / cube.edge;
  }
  RunRound(scene,
           {.scale = 2, .range = 3, .smooths = smooths, .aligns = false},
           &mesh);
  const VertexCorners neighbors = RefineScene::Neighbors(mesh);
  double roughness = 0;
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const uint32_t next : neighbors.Of(v)) {
      mean += mesh.positions[next] / double(neighbors.Of(v).size());
    }
    const Eigen::Vector3d deviation = mesh.positions[v] - mean;
    roughness += std::abs(deviation.dot(mesh.normals[v].cast<double>()));
  }
  return roughness * cube.edge / scene.Pixel() / double(mesh.positions.size());
}

TEST(RefineOnce, KeepsStepsWhereItDoesNotSmooth) {
  const RefineScene scene = testing::MakeRefineScene();
  EXPECT_LT(RoughnessAfter(scene, true), 0.5 * RoughnessAfter(scene, false));
}

TEST(RefineSurface, LeavesWhatNobodySees) {
  const RefineScene scene = testing::MakeRefineScene(10);
  const IndexedMesh before = BumpyMesh(scene);
  const RefinedSurface refined = Refine(scene);
  const RoundSummary& last = refined.summary.rounds.back();
  EXPECT_LT(last.num_seen, last.num_points);
  size_t num_bottom = 0;
  double top_before = 0, top_after = 0;
  for (size_t v = 0; v < before.positions.size(); ++v) {
    const double height = before.positions[v].normalized().z();
    if (height < -0.98) {
      ++num_bottom;
      EXPECT_EQ(refined.mesh.positions[v], before.positions[v]);
    } else if (height > 0) {
      top_before += std::abs(before.positions[v].norm() - RefineScene::kRadius);
      top_after +=
          std::abs(refined.mesh.positions[v].norm() - RefineScene::kRadius);
    }
  }
  EXPECT_GT(num_bottom, 10u);
  EXPECT_LT(top_after, top_before / 4);
}

TEST(RefineSurface, GivesTheSameBytesForAnyNumberOfThreads) {
  const RefineScene scene = testing::MakeRefineScene();
  const RefinedSurface one = Refine(scene, Context(1));
  const RefinedSurface two = Refine(scene, Context(2));
  EXPECT_EQ(one.mesh.positions, two.mesh.positions);
  EXPECT_EQ(one.mesh.normals, two.mesh.normals);
  EXPECT_EQ(one.summary.agreement_after, two.summary.agreement_after);
}

TEST(RefineSurface, CanBeCancelledInEveryPhase) {
  const RefineScene scene = testing::MakeRefineScene();
  const IndexedMesh mesh = RefineScene::Mesh(10, Bumps(2 * scene.Pixel()));
  std::atomic<bool> stop{false};
  Stopper counter(-1, &stop);
  RefineMesh(mesh, scene, Context(2, &counter, &stop));
  EXPECT_GE(counter.phases.size(), 5u);
  for (size_t phase = 0; phase < counter.phases.size(); ++phase) {
    stop = false;
    Stopper stopper(int(phase), &stop);
    EXPECT_THROW(RefineMesh(mesh, scene, Context(2, &stopper, &stop)),
                 CancelledError);
    EXPECT_EQ(stopper.phases.size(), phase + 1) << "it went on";
  }
}

TEST(RefineSurface, RefusesWhatItCannotUse) {
  RefineScene scene = testing::MakeRefineScene();
  const auto refine = [&](IndexedMesh mesh) {
    RefineSurface(std::move(mesh),
                  scene.test.region.cube,
                  RefineOptions(),
                  Context(2),
                  &scene.test.views);
  };
  const auto message = [&](IndexedMesh mesh) -> std::string {
    try {
      refine(std::move(mesh));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message({}), HasSubstr("no triangles"));
  scene.test.views[3].pyramid = ImagePyramid();
  EXPECT_THAT(message(Sphere(4, 0.5)), HasSubstr("no image"));
  scene.test.views.resize(1);
  EXPECT_THAT(message(Sphere(4, 0.5)), HasSubstr("at least 2 views"));
}

TEST(RefineOptions, AreChecked) {
  EXPECT_NO_THROW(RefineOptions().Check());
  const auto refused = [](auto change) {
    RefineOptions options;
    change(options);
    EXPECT_THROW(options.Check(), OptionError);
  };
  refused([](RefineOptions& o) { o.views.max_views = 1; });
  refused([](RefineOptions& o) { o.coarse_rounds = 5; });
  refused([](RefineOptions& o) { o.coarse_passes = 0; });
  refused([](RefineOptions& o) { o.alignment_steps = -1; });
  refused([](RefineOptions& o) { o.alignment_steps = 17; });
  refused([](RefineOptions& o) { o.patch.radius = 5; });
  refused([](RefineOptions& o) { o.fit_radius = 0; });
  refused([](RefineOptions& o) { o.patch.chroma_weight = -1; });
  refused([](RefineOptions& o) { o.smoothness = 0; });
}

}  // namespace
}  // namespace octacut
