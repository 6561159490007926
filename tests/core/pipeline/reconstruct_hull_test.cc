#include "core/pipeline/reconstruct_hull.h"

#include <gtest/gtest.h>

#include <atomic>

#include "core/base/check_option.h"
#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"
#include "tests/core/pipeline/reconstruction_checks.h"

namespace octacut {
namespace {

TEST(ReconstructHull, IsClosedAndNeedsNoImages) {
  SceneSpec spec = QuickScene("torus", 120, 90, 16);
  spec.lighting.num_samples = 2;
  const SyntheticScene synthetic = MakeScene(spec, Context(2));
  Scene scene = ToScene(synthetic);
  const Region region =
      EstimateRegion(scene.views, scene.points, RegionOptions(), Context(2));
  for (View& view : scene.views) {
    view.image = cv::Mat();
  }
  HullReconstructionOptions options;
  options.hull.hull_level = 6;
  const HullReconstruction hull =
      ReconstructHull(scene, region, options, Context(2));
  EXPECT_EQ(hull.audit.DescribeFailure(), "");
  EXPECT_EQ(hull.audit.genus, 1);
  EXPECT_TRUE(hull.mesh.has_vertex_normals());
  EXPECT_GT(hull.audit.volume,
            AuditMesh(synthetic.reference, Context(1)).volume);
  const std::atomic<bool> stop{true};
  EXPECT_THROW(
      ReconstructHull(scene, region, options, Context(1, nullptr, &stop)),
      CancelledError);
  for (View& view : scene.views) {
    view.mask = cv::Mat::zeros(view.mask.size(), CV_8UC1);
  }
  EXPECT_THROW(ReconstructHull(scene, region, options, Context(2)), InputError);
}

TEST(ReconstructHull, ChecksOptionsBeforeAnythingElse) {
  HullReconstructionOptions options;
  options.hull.hull_level = 0;
  EXPECT_THROW(ReconstructHull(Scene(), Region(), options, Context(1)),
               OptionError);
}

}  // namespace
}  // namespace octacut
