#include "core/refine/offset_search.h"

#include <gtest/gtest.h>

#include "core/refine/refine_options.h"
#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::RefineScene;

class OffsetSearchTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new RefineScene(testing::MakeRefineScene());
  }
  static void TearDownTestSuite() { delete scene_; }

  // Offsets of a sphere that is `pixels` too large, in pixels, searched with
  // the defaults.
  std::vector<OffsetMeasurement> Measure(double pixels) const {
    const RefineOptions options;
    const OffsetSearch search = {.range = options.range,
                                 .step = options.step,
                                 .spacing = 1,
                                 .patch_radius = options.patch_radius,
                                 .pixel_noise = options.pixel_noise,
                                 .min_score = options.min_score};
    const IndexedMesh mesh = scene_->ToUnitMesh(RefineScene::Mesh(
        16, [&](const auto&) { return pixels * scene_->Pixel(); }));
    const std::vector<LocalSurface> surfaces =
        FitLocalSurfaces(mesh,
                         RefineScene::Neighbors(mesh),
                         testing::AllVertices(mesh),
                         0.1,
                         Context(2));
    const std::vector<ChosenViews> choices = ChooseViews(scene_->test.views,
                                                         RayScene(mesh),
                                                         surfaces,
                                                         0.02,
                                                         ViewChoiceOptions(),
                                                         Context(2));
    const Context context(2);
    Phase phase(context, "test");
    std::vector<OffsetMeasurement> measurements = SearchOffsets(
        scene_->test.views, surfaces, choices, search, context, &phase);
    for (OffsetMeasurement& measurement : measurements) {
      measurement.offset *=
          float(scene_->test.region.cube.edge / scene_->Pixel());
    }
    return measurements;
  }

  static RefineScene* scene_;
};
RefineScene* OffsetSearchTest::scene_ = nullptr;

TEST_F(OffsetSearchTest, FindsTheSurfaceToAFractionOfAPixel) {
  for (const double pixels : {-1.3, 0.0, 0.6, 1.2}) {
    double weights = 0, sum = 0, error = 0;
    for (const OffsetMeasurement& measurement : Measure(pixels)) {
      weights += measurement.weight;
      sum += measurement.weight * measurement.offset;
      error += measurement.weight * std::abs(measurement.offset + pixels);
    }
    ASSERT_GT(weights, 0);
    EXPECT_NEAR(sum / weights, -pixels, 0.1);
    EXPECT_LT(error / weights, 0.15);
  }
}

TEST_F(OffsetSearchTest, HasNothingBeyondItsRange) {
  size_t num_found = 0, num_all = 0;
  for (const OffsetMeasurement& measurement : Measure(4)) {
    num_found += measurement.weight > 1 ? 1 : 0;
    ++num_all;
  }
  EXPECT_LT(num_found, num_all / 20);
}

TEST_F(OffsetSearchTest, TellsAgreementBeforeAndAtThePeak) {
  for (const OffsetMeasurement& measurement : Measure(1)) {
    EXPECT_LE(measurement.score_before, measurement.score);
    EXPECT_LE(measurement.score, 1.05);
  }
}

}  // namespace
}  // namespace octacut
