#include "core/refine/offset_search.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/refine/refine_options.h"
#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::RefineScene;

// Offsets of the vertices of a sphere that is `pixels` too large, in pixels,
// searched with these options.
std::vector<OffsetMeasurement> MeasureIn(
    const RefineScene& scene,
    double pixels,
    const RefineOptions& options = RefineOptions()) {
  const OffsetSearch search =
      MakeOffsetSearch(options, RefineOptions::kRange, 1);
  const IndexedMesh mesh = scene.ToUnitMesh(RefineScene::Mesh(
      16, [&](const auto&) { return pixels * scene.Pixel(); }));
  const Context context(2);
  const std::vector<LocalSurface> surfaces =
      FitLocalSurfaces(mesh,
                       RefineScene::Neighbors(mesh),
                       testing::AllVertices(mesh),
                       0.1,
                       context);
  const std::vector<ChosenViews> choices = ChooseViews(scene.test.views,
                                                       RayScene(mesh),
                                                       surfaces,
                                                       {.clearance = 0.02},
                                                       options.views,
                                                       context);
  Phase phase(context, "test");
  std::vector<OffsetMeasurement> measurements = SearchOffsets(
      scene.test.views, surfaces, choices, search, context, &phase);
  for (size_t i = 0; i < measurements.size(); ++i) {
    // Offsets are those of the fitted surface.
    measurements[i].offset = (measurements[i].offset + surfaces[i].height) *
                             float(scene.test.region.cube.edge / scene.Pixel());
  }
  return measurements;
}

class OffsetSearchTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new RefineScene(testing::MakeRefineScene());
  }
  static void TearDownTestSuite() { delete scene_; }

  std::vector<OffsetMeasurement> Measure(double pixels) const {
    return MeasureIn(*scene_, pixels);
  }

  static RefineScene* scene_;
};
RefineScene* OffsetSearchTest::scene_ = nullptr;

TEST_F(OffsetSearchTest, TellsWhetherTheSurfaceLooksMatt) {
  constexpr double kBrighter = 40;  // every eighth photograph, grey levels
  const auto mean_mattness = [](const RefineScene& scene) {
    double sum = 0;
    double count = 0;
    for (const OffsetMeasurement& measurement : MeasureIn(scene, 0)) {
      if (measurement.is_measured) {
        sum += measurement.mattness;
        ++count;
      }
    }
    return sum / count;
  };
  SyntheticScene uneven = scene_->test.synthetic;
  for (size_t i = 0; i < uneven.views.size(); i += 8) {
    uneven.views[i].image = uneven.views[i].image + cv::Scalar::all(kBrighter);
  }
  const double even = mean_mattness(*scene_);
  EXPECT_GT(even, 0.8);
  EXPECT_LT(mean_mattness({testing::MakeTestScene(std::move(uneven))}),
            even - 0.5);
}

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

// The mean offset that views find on a sphere which hardly differs from their
// background and is some ten pixels large, where they see it: 0 is right.
double MeanOffsetOnFaintSphere(int mask_offset, float border_shift) {
  RefineScene scene = {
      testing::MakeTestScene(testing::RenderOnce(mask_offset, [](int offset) {
        SceneSpec spec = testing::RefineSceneSpec();
        spec.rig.width = 48;
        spec.rig.height = 36;
        spec.texture.contrast = 0.3;
        spec.degrade.mask_offset = offset;
        return spec;
      }))};
  for (PreparedView& view : scene.test.views) {
    view.border_shift = border_shift;
  }
  double weights = 0;
  double sum = 0;
  for (const OffsetMeasurement& measurement : MeasureIn(scene, 0)) {
    weights += measurement.weight;
    sum += measurement.weight * measurement.offset;
  }
  EXPECT_GT(weights, 0);
  return sum / weights;
}

// Views from the side show the outline, where the background is mixed into the
// colours. Compared as well, they draw offsets inside, here by a quarter of a
// pixel.
TEST_F(OffsetSearchTest, IsNotLedByTheBackgroundAtOutlines) {
  EXPECT_NEAR(MeanOffsetOnFaintSphere(0, 0), 0, 0.05);
}

TEST_F(OffsetSearchTest, IsNotLedByTheBackgroundWithinLargeMasks) {
  EXPECT_LT(MeanOffsetOnFaintSphere(2, 0), -0.2);
  EXPECT_NEAR(MeanOffsetOnFaintSphere(2, 2), 0, 0.05);
}

TEST_F(OffsetSearchTest, HasNothingBeyondItsRange) {
  size_t num_found = 0, num_all = 0;
  for (const OffsetMeasurement& measurement : Measure(4)) {
    num_found += measurement.weight > 1 ? 1 : 0;
    ++num_all;
  }
  EXPECT_LT(num_found, num_all / 20);
}

TEST_F(OffsetSearchTest, TellsAgreementBefore) {
  const std::vector<OffsetMeasurement> on_surface = Measure(0);
  const std::vector<OffsetMeasurement> beside = Measure(1);
  ASSERT_EQ(on_surface.size(), beside.size());
  size_t num_found = 0, num_better = 0;
  for (size_t i = 0; i < beside.size(); ++i) {
    EXPECT_LE(on_surface[i].score_before, 1.05);
    if (beside[i].weight > 0) {
      ++num_found;
      num_better += on_surface[i].score_before > beside[i].score_before + 0.02;
    }
  }
  // A pixel from the surface views agree less than on it, nearly everywhere.
  EXPECT_GT(num_found, 100u);
  EXPECT_GT(num_better, num_found * 9 / 10);
}

// Means over the offsets that were found.
struct Quality {
  double error = 0;
  double weight = 0;
  double error_in_deviations = 0;
};

Quality MeasureQuality(const RefineScene& scene, const RefineOptions& options) {
  Quality sum;
  double count = 0;
  for (const OffsetMeasurement& measurement : MeasureIn(scene, 0, options)) {
    if (measurement.weight > 0) {
      const double error = std::abs(measurement.offset);
      sum.error += error;
      sum.weight += measurement.weight;
      sum.error_in_deviations += error * measurement.weight;
      ++count;
    }
  }
  return {
      sum.error / count, sum.weight / count, sum.error_in_deviations / count};
}

TEST(OffsetSearch, FewNoisyViewsWeighAsLittleAsTheyTell) {
  const RefineScene scene = testing::MakeRefineScene(-60, 20);
  RefineOptions options;
  options.views.max_views = 3;
  const Quality few = MeasureQuality(scene, options);
  options.views.max_views = 16;
  const Quality many = MeasureQuality(scene, options);
  EXPECT_GT(few.error, 2 * many.error);
  EXPECT_LT(few.weight, many.weight / 2);
  EXPECT_LT(few.error_in_deviations, 1.5 * many.error_in_deviations);
}

TEST(OffsetSearch, GlossMisleadsLessWhereChromaWeighsMore) {
  SceneSpec spec = testing::RefineSceneSpec();
  spec.texture.kind = TextureKind::kPainted;
  spec.texture.contrast = 0.1;
  spec.lighting.shininess = 20;
  spec.lighting.specular = 3;
  const RefineScene scene = {testing::MakeTestScene(spec)};
  RefineOptions options;
  options.patch.chroma_weight = 1;
  const Quality as_taken = MeasureQuality(scene, options);
  options.patch.chroma_weight = 4;
  const Quality by_chroma = MeasureQuality(scene, options);
  EXPECT_LT(by_chroma.error, 0.8 * as_taken.error);
}

}  // namespace
}  // namespace octacut
