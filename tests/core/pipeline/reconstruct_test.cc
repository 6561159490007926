// What a run promises whatever the object: the same bytes, errors, summaries.
#include "core/pipeline/reconstruct.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>

#include "core/base/error.h"
#include "core/mesh/normals.h"
#include "tests/core/base/stopper.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"
#include "tests/core/pipeline/reconstruction_checks.h"

namespace octacut {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MeanDistance;
using testing::Stopper;

struct SmallScene {
  IndexedMesh reference;
  Scene scene;
  Region region;
  ReconstructionOptions options;
};

// 32^3 to 64^3.
SmallScene MakeSmallScene(const SceneSpec& spec) {
  const SyntheticScene synthetic = MakeScene(spec, Context(2));
  SmallScene small;
  small.reference = synthetic.reference;
  small.scene = ToScene(synthetic);
  small.region = EstimateRegion(
      small.scene.views, small.scene.points, RegionOptions(), Context(2));
  small.options.hull.hull_level = 5;
  small.options.target_level = 6;
  return small;
}

SmallScene MakeSmallScene(const std::string& object = "torus") {
  SceneSpec spec = QuickScene(object, 120, 90, 16);
  spec.lighting.num_samples = 2;
  return MakeSmallScene(spec);
}

Reconstruction RunSmall(const SmallScene& small, const Context& context) {
  return Reconstruct(small.scene, small.region, small.options, context);
}

TEST(Reconstruct, GivesTheSameBytesForAnyNumberOfThreads) {
  const SmallScene small = MakeSmallScene("fingers");
  const Reconstruction expected = RunSmall(small, Context(1));
  const IndexedMesh expected_mesh = ToIndexedMesh(expected.mesh);
  EXPECT_GT(expected_mesh.triangles.size(), 1000u);
  for (const int num_threads : {2, 4}) {
    const Reconstruction again = RunSmall(small, Context(num_threads));
    const IndexedMesh mesh = ToIndexedMesh(again.mesh);
    EXPECT_EQ(mesh.positions, expected_mesh.positions);
    EXPECT_EQ(mesh.triangles, expected_mesh.triangles);
    EXPECT_EQ(mesh.normals, expected_mesh.normals);
    EXPECT_EQ(mesh.colors, expected_mesh.colors);
    for (size_t i = 0; i < expected.summary.levels.size(); ++i) {
      EXPECT_EQ(again.summary.levels[i].cut_cost,
                expected.summary.levels[i].cut_cost);
    }
  }
}

TEST(Reconstruct, RefinesByThePhotographs) {
  SmallScene small = MakeSmallScene();
  small.options.refine = false;
  const Reconstruction plain = RunSmall(small, Context(2));
  EXPECT_FALSE(plain.summary.refinement.has_value());
  small.options.refine = true;
  const Reconstruction refined = RunSmall(small, Context(1));
  ASSERT_TRUE(refined.summary.refinement.has_value());
  EXPECT_GT(refined.summary.refinement->num_moved,
            refined.mesh.n_vertices() / 2);
  EXPECT_EQ(refined.audit.DescribeFailure(), "");
  const IndexedMesh mesh = ToIndexedMesh(refined.mesh);
  EXPECT_LT(MeanDistance(mesh, small.reference),
            0.5 * MeanDistance(ToIndexedMesh(plain.mesh), small.reference));
  EXPECT_EQ(mesh.normals, ComputeVertexNormals(mesh, Context(2)));
  const IndexedMesh again = ToIndexedMesh(RunSmall(small, Context(3)).mesh);
  EXPECT_EQ(again.positions, mesh.positions);
  EXPECT_EQ(again.normals, mesh.normals);
  EXPECT_EQ(again.colors, mesh.colors);
}

TEST(Reconstruct, SaysWhatItHasDone) {
  const SmallScene small = MakeSmallScene();
  std::vector<int> observed;
  std::vector<size_t> observed_triangles;
  const Reconstruction result =
      Reconstruct(small.scene,
                  small.region,
                  small.options,
                  Context(2),
                  [&](int level, const IndexedMesh& mesh) {
                    observed.push_back(level);
                    observed_triangles.push_back(mesh.triangles.size());
                    const MeshAudit audit = AuditMesh(mesh, Context(1));
                    EXPECT_TRUE(audit.IsClosed()) << level;
                    EXPECT_TRUE(audit.IsEdgeManifold()) << level;
                    EXPECT_TRUE(audit.IsVertexManifold()) << level;
                  });
  EXPECT_THAT(observed, ElementsAre(-1, 5, 6));
  EXPECT_GT(observed_triangles[2], 2 * observed_triangles[1]);

  EXPECT_EQ(result.audit.DescribeFailure(), "");
  EXPECT_TRUE(result.mesh.has_vertex_normals());
  EXPECT_TRUE(result.mesh.has_vertex_colors());
  EXPECT_EQ(result.audit.num_vertices, result.mesh.n_vertices());
  EXPECT_EQ(result.audit.num_edges, result.mesh.n_edges());
  EXPECT_EQ(result.audit.num_triangles, result.mesh.n_faces());
  const ReconstructionSummary& summary = result.summary;
  EXPECT_GT(summary.hull.num_voxels, 1000u);
  EXPECT_GT(summary.evidence.num_depths, summary.evidence.num_agreeing);
  EXPECT_GT(summary.evidence.num_agreeing, 0u);
  ASSERT_EQ(summary.levels.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const LevelSummary& level = summary.levels[i];
    EXPECT_EQ(level.level, 5 + int(i));
    EXPECT_EQ(level.resolution, 32 << i);
    EXPECT_GT(level.num_crust_voxels, level.num_cut_voxels);
    EXPECT_GT(level.num_cut_voxels, 500u);
    EXPECT_GT(level.num_graph_nodes, 2 * level.num_crust_voxels);
    EXPECT_GT(level.cut_cost, 0);
    EXPECT_GE(level.consistency.num_voxels, level.num_crust_voxels);
    EXPECT_LT(level.consistency.num_unseen, level.consistency.num_voxels / 2);
    EXPECT_GT(level.consistency.mean, 0);
    EXPECT_LT(level.consistency.mean, 1);
  }
  EXPECT_EQ(summary.levels[0].num_crust_voxels, summary.hull.num_voxels);
}

// A plain object of a known colour under even light, which no view shows from
// below.
TEST(Reconstruct, ColorsAreThoseOfThePhotographs) {
  SceneSpec spec = QuickScene("sphere", 120, 90, 12);
  spec.texture.kind = TextureKind::kPlain;
  spec.texture.color = {0.8f, 0.3f, 0.1f};
  spec.lighting.num_samples = 2;
  spec.rig.kind = RigKind::kRings;
  spec.rig.min_elevation = 20;
  spec.rig.max_elevation = 70;
  const Scene scene = ToScene(MakeScene(spec, Context(2)));
  SmallScene small = MakeSmallScene("sphere");
  small.scene = scene;
  const Reconstruction result = RunSmall(small, Context(2));
  size_t reddish = 0;
  size_t num_grey = 0;
  for (const auto vertex : result.mesh.vertices()) {
    const SurfaceMesh::Color& color = result.mesh.color(vertex);
    reddish += color[0] > color[1] + 20 && color[1] > color[2];
    num_grey += color[0] == color[1] && color[1] == color[2];
  }
  EXPECT_GT(reddish, result.mesh.n_vertices() * 9 / 10);
  EXPECT_EQ(num_grey, 0u);
}

TEST(Reconstruct, CanBeCancelledInEveryPhase) {
  // As little work as has all phases.
  SceneSpec spec = QuickScene("sphere", 60, 45, 8);
  spec.lighting.num_samples = 1;
  SmallScene small = MakeSmallScene(spec);
  small.options.hull.hull_level = 4;
  small.options.target_level = 5;
  std::atomic<bool> stop{false};
  Stopper counter(-1, &stop);
  RunSmall(small, Context(2, &counter, &stop));
  EXPECT_THAT(counter.phases, Contains("visual hull"));
  EXPECT_THAT(counter.phases, Contains("photo-consistency of level 5"));
  for (size_t phase = 0; phase < counter.phases.size(); ++phase) {
    stop = false;
    Stopper stopper(int(phase), &stop);
    EXPECT_THROW(RunSmall(small, Context(2, &stopper, &stop)), CancelledError)
        << counter.phases[phase];
    EXPECT_EQ(stopper.phases.size(), phase + 1) << "it went on";
  }
  stop = true;
  EXPECT_THROW(RunSmall(small, Context(1, nullptr, &stop)), CancelledError);
}

TEST(Reconstruct, RefusesScenesItCannotUse) {
  const SmallScene small = MakeSmallScene("sphere");
  const auto message_for = [&](const std::function<void(Scene*)>& spoil) {
    SmallScene spoilt = small;
    // Views share their pixels: none is written to below.
    spoil(&spoilt.scene);
    try {
      RunSmall(spoilt, Context(2));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message_for([](Scene* scene) { scene->views.resize(2); }),
              AllOf(HasSubstr("2 views"), HasSubstr("at least 3")));
  EXPECT_THAT(message_for([](Scene* scene) { scene->views.clear(); }),
              HasSubstr("0 views"));
  EXPECT_THAT(
      message_for([](Scene* scene) { scene->views[3].image = cv::Mat(); }),
      AllOf(HasSubstr("view_003"), HasSubstr("image")));
  EXPECT_THAT(
      message_for([](Scene* scene) { scene->views[1].mask = cv::Mat(); }),
      AllOf(HasSubstr("view_001"), HasSubstr("mask")));
  EXPECT_THAT(message_for([](Scene* scene) {
                for (View& view : scene->views) {
                  view.mask = cv::Mat::zeros(view.mask.size(), CV_8UC1);
                }
              }),
              AnyOf(HasSubstr("hull is empty"), HasSubstr("surface vanished")));
}

// Views whose silhouettes are those of a surface as large as `area` faces of
// the cube; of few pixels, so that they need little memory themselves.
Scene SceneOfArea(double area, int num_views = 3) {
  View view;
  view.camera = {100, 100, 100, 100, 50, 50};
  view.cam_from_world.translation = {0, 0, 2};
  // 4 * (pixels of the disc) * (2 / 100)^2 = area
  view.mask = cv::Mat::zeros(100, 100, CV_8UC1);
  view.mask.rowRange(0, int(std::lround(area * 6.25))).setTo(255);
  return {std::vector<View>(size_t(num_views), view), {}};
}

size_t BytesOf(const Scene& scene,
               const ReconstructionOptions& options,
               int num_threads = 1) {
  const BoundingCube cube{Eigen::Vector3d::Constant(-0.5), 1};
  return EstimateReconstructionBytes(
      scene, cube, options, Context(num_threads));
}

TEST(EstimateReconstructionBytes, GrowsWithSurfaceLevelAndViews) {
  const Scene scene = SceneOfArea(2.56);
  ReconstructionOptions options;
  options.target_level = 9;
  const size_t bytes = BytesOf(scene, options);
  // 0.9 million vertices, of 1000 bytes each in refinement.
  EXPECT_GT(bytes, 850'000'000u);
  EXPECT_LT(bytes, 900'000'000u);
  EXPECT_GT(BytesOf(SceneOfArea(5.12), options), bytes + bytes * 9 / 10);
  options.target_level = 10;
  EXPECT_GT(BytesOf(scene, options), 3 * bytes);
  options.target_level = 9;
  // Image and silhouette sums: at least 8 bytes per pixel.
  EXPECT_GE(BytesOf(SceneOfArea(2.56, 13), options),
            bytes + size_t{8} * 10 * 100 * 100);
}

TEST(EstimateReconstructionBytes, CountsCrustAndCut) {
  const Scene scene = SceneOfArea(2.56);
  ReconstructionOptions options;
  options.target_level = 9;
  options.refine = false;
  const size_t bytes = BytesOf(scene, options);
  options.crust.crust_dilation = 4;
  EXPECT_GT(BytesOf(scene, options), bytes + bytes / 2);
  options.crust.crust_dilation = 2;
  options.cut.lean = true;
  EXPECT_LT(BytesOf(scene, options), bytes);
}

TEST(EstimateReconstructionBytes, CountsRefinement) {
  const Scene scene = SceneOfArea(2.56);
  ReconstructionOptions options;
  const size_t refined = BytesOf(scene, options);
  options.refine = false;
  EXPECT_GT(refined, BytesOf(scene, options));
}

// Where the target is coarse the depth sweep needs more than the cut.
TEST(EstimateReconstructionBytes, CountsTheDepthSweepOfEveryThread) {
  ReconstructionOptions options;
  options.target_level = options.hull.hull_level = 8;
  options.refine = false;
  const size_t one = BytesOf({}, options);
  const size_t four = BytesOf({}, options, 4);
  // Scores of 512^2 rays on 256 planes.
  EXPECT_EQ(four, size_t(4) * 512 * 512 * 256 * sizeof(float));
  EXPECT_LT(one, four);
}

}  // namespace
}  // namespace octacut
