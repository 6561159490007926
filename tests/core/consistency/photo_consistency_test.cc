#include "core/consistency/photo_consistency.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "tests/core/base/error_texts.h"
#include "tests/core/consistency/sphere_scene.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using testing::MakeSphereScene;
using testing::SphereScene;

constexpr int kPhiLevel = SphereScene::kLevel;

double MedianPhi(const SphereScene& sphere,
                 const std::vector<float>& phi,
                 double from,
                 double to) {
  std::vector<float> chosen;
  sphere.shell.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const double height = sphere.Height(code);
    if (height >= from && height <= to) {
      chosen.push_back(phi[index]);
    }
  });
  EXPECT_GT(chosen.size(), 100u);
  std::nth_element(
      chosen.begin(), chosen.begin() + chosen.size() / 2, chosen.end());
  return chosen[chosen.size() / 2];
}

class Measure : public ::testing::TestWithParam<ConsistencyMeasure> {
 protected:
  ConsistencyOptions Options() const {
    ConsistencyOptions options;
    options.measure = GetParam();
    return options;
  }
};

TEST_P(Measure, IsLowOnTheTrueSurfaceAndHighBesideIt) {
  const SphereScene sphere = MakeSphereScene();
  const PhotoConsistency consistency = sphere.Estimate(Options());
  ASSERT_EQ(consistency.phi.size(), sphere.shell.Size());
  for (const float phi : consistency.phi) {
    ASSERT_GE(phi, 0);
    ASSERT_LE(phi, 1);
  }
  const double on_surface = MedianPhi(sphere, consistency.phi, -0.35, 0.35);
  const double outside = MedianPhi(sphere, consistency.phi, 2.6, 3.4);
  const double inside = MedianPhi(sphere, consistency.phi, -3.4, -2.6);
  EXPECT_LT(on_surface, 0.6 * outside);
  EXPECT_LT(on_surface, 0.6 * inside);
  // It falls all the way to the surface and rises behind it.
  double before = outside;
  for (const double height : {2.0, 1.0, 0.0}) {
    const double median =
        MedianPhi(sphere, consistency.phi, height - 0.35, height + 0.35);
    EXPECT_LT(median, before) << height;
    before = median;
  }
  EXPECT_LT(before, MedianPhi(sphere, consistency.phi, -1.85, -1.15));
}

// Height, voxels, at which phi is lowest: of the parabola through the mean at
// heights -1, 0 and 1.
double HeightOfLeastPhi(const SphereScene& sphere,
                        const std::vector<float>& phi) {
  const double inside = MedianPhi(sphere, phi, -1.3, -0.7);
  const double middle = MedianPhi(sphere, phi, -0.3, 0.3);
  const double outside = MedianPhi(sphere, phi, 0.7, 1.3);
  return (inside - outside) / (2 * (inside - 2 * middle + outside));
}

TEST_P(Measure, IsLowestOnACurvedSurfaceWhereItsCurvatureIsKnown) {
  SphereScene sphere = MakeSphereScene();
  ConsistencyOptions options = Options();
  options.patch_radius = 4;
  EXPECT_NEAR(HeightOfLeastPhi(sphere, sphere.Estimate(options).phi), 0, 0.03);
  // Planar patches lie above the surface by r^2 / 2R, with the mean square
  // distance r^2 = 2 (4^2 + 3^2 + 2^2 + 1^2) 2 / 9 of their samples, and fit
  // best below it: by as much if views from the side saw all of them.
  double mean_curvature = 0;
  for (SurfaceShape& shape : sphere.shapes) {
    mean_curvature += shape.curvature / double(sphere.shapes.size());
    shape.curvature = 0;
  }
  const double height = HeightOfLeastPhi(sphere, sphere.Estimate(options).phi);
  EXPECT_LT(height, -0.05);
  EXPECT_GT(height, -13.33 / 2 * mean_curvature);
}

TEST_P(Measure, IsNeutralWhereFewerThanTwoViewsSee) {
  const SphereScene sphere = MakeSphereScene();
  const ViewSet one(sphere.test.views.begin(), sphere.test.views.begin() + 1);
  ConsistencyOptions options = Options();
  options.neutral = 0.375;
  const PhotoConsistency consistency = sphere.Estimate(options, one);
  for (const float phi : consistency.phi) {
    ASSERT_EQ(phi, 0.375f);
  }
  EXPECT_EQ(consistency.summary.num_unseen, sphere.shell.Size());
  EXPECT_EQ(consistency.summary.num_voxels, sphere.shell.Size());
  EXPECT_EQ(consistency.summary.mean, 0);
  // No normal: unseen, too.
  SphereScene blind = sphere;
  std::fill(blind.shapes.begin(),
            blind.shapes.end(),
            SurfaceShape{Eigen::Vector3f::Zero(), 0});
  for (const float phi : blind.Estimate(options).phi) {
    ASSERT_EQ(phi, 0.375f);
  }
}

TEST_P(Measure, SumsUpTheSameForAnyNumberOfThreads) {
  const SphereScene sphere = MakeSphereScene();
  const PhotoConsistency consistency =
      sphere.Estimate(Options(), sphere.test.views, Context(1));
  // Seen voxels have phi == neutral almost never.
  size_t num_neutral = 0;
  double sum = 0;
  for (const float phi : consistency.phi) {
    num_neutral += phi == 0.5f;
    sum += phi;
  }
  const ConsistencySummary& summary = consistency.summary;
  EXPECT_EQ(summary.num_voxels, consistency.phi.size());
  EXPECT_NEAR(double(summary.num_unseen),
              double(num_neutral),
              0.01 * double(summary.num_voxels));
  EXPECT_NEAR(summary.mean * double(summary.num_voxels - summary.num_unseen) +
                  0.5 * double(summary.num_unseen),
              sum,
              1e-3 * sum);
  for (const int num_threads : {2, 4}) {
    const PhotoConsistency again =
        sphere.Estimate(Options(), sphere.test.views, Context(num_threads));
    EXPECT_EQ(again.phi, consistency.phi);
    EXPECT_EQ(again.summary.mean, summary.mean);
    EXPECT_EQ(again.summary.num_unseen, summary.num_unseen);
  }
}

INSTANTIATE_TEST_SUITE_P(
    PhotoConsistency,
    Measure,
    ::testing::Values(ConsistencyMeasure::kNormalizedVariance,
                      ConsistencyMeasure::kNcc,
                      ConsistencyMeasure::kVariance),
    [](const auto& instance) {
      switch (instance.param) {
        case ConsistencyMeasure::kNormalizedVariance:
          return "NormalizedVariance";
        case ConsistencyMeasure::kNcc:
          return "Ncc";
        default:
          return "Variance";
      }
    });

class NormalizingMeasure : public Measure {};

// Plain surfaces say nothing: neither consistent nor inconsistent.
TEST_P(NormalizingMeasure, IsNeutralOnPlainPatches) {
  SphereScene sphere = MakeSphereScene();
  for (View& view : sphere.test.scene.views) {
    view.image = cv::Mat(view.mask.size(), CV_8UC3, cv::Scalar(90, 120, 60));
    view.mask = cv::Mat(view.mask.size(), CV_8UC1, cv::Scalar::all(255));
  }
  sphere.test.views =
      PrepareViews(sphere.test.scene, sphere.test.region.cube, Context(1));
  const PhotoConsistency consistency = sphere.Estimate(Options());
  EXPECT_LT(consistency.summary.num_unseen, sphere.shell.Size() / 10);
  for (const float phi : consistency.phi) {
    ASSERT_NEAR(phi, 0.5, 1e-3);
  }
}

// Gain and offset of whole images change nothing but the rounding of pixels
// and what the noise weighs.
TEST_P(NormalizingMeasure, DoesNotFeelExposure) {
  SphereScene sphere = MakeSphereScene();
  ConsistencyOptions options = Options();
  options.pixel_noise = 0.5;
  const std::vector<float> before = sphere.Estimate(options).phi;
  for (size_t i = 0; i < sphere.test.scene.views.size(); ++i) {
    View& view = sphere.test.scene.views[i];
    const double gain = i % 2 == 0 ? 0.7 : 0.9;
    const double offset = double(i % 3) * 8;
    cv::Mat changed;
    view.image.convertTo(changed, -1, gain, offset);
    view.image = changed;
  }
  sphere.test.views =
      PrepareViews(sphere.test.scene, sphere.test.region.cube, Context(1));
  const std::vector<float> after = sphere.Estimate(options).phi;
  ASSERT_EQ(before.size(), after.size());
  double sum = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    sum += std::abs(before[i] - after[i]);
    ASSERT_NEAR(before[i], after[i], 0.12);
  }
  EXPECT_LT(sum / double(before.size()), 0.01);
  // The plain variance does feel it.
  ConsistencyOptions plain;
  plain.measure = ConsistencyMeasure::kVariance;
  EXPECT_GT(MedianPhi(sphere, sphere.Estimate(plain).phi, -0.35, 0.35), 0.15);
}

INSTANTIATE_TEST_SUITE_P(
    PhotoConsistency,
    NormalizingMeasure,
    ::testing::Values(ConsistencyMeasure::kNormalizedVariance,
                      ConsistencyMeasure::kNcc),
    [](const auto& instance) {
      return instance.param == ConsistencyMeasure::kNcc ? "Ncc"
                                                        : "NormalizedVariance";
    });

TEST(ConsistencySummary, AddsUpAsOneSet) {
  ConsistencySummary a;
  a.num_voxels = 10;
  a.num_unseen = 4;
  a.mean = 0.5;
  ConsistencySummary b;
  b.num_voxels = 5;
  b.num_unseen = 3;
  b.mean = 0.25;
  a.Add(b);
  EXPECT_EQ(a.num_voxels, 15u);
  EXPECT_EQ(a.num_unseen, 7u);
  EXPECT_DOUBLE_EQ(a.mean, (6 * 0.5 + 2 * 0.25) / 8);
  ConsistencySummary none;
  none.Add(none);
  EXPECT_EQ(none.mean, 0);
}

TEST(ConsistencyOptions, AreRejectedWithFieldAndConstraint) {
  EXPECT_NO_THROW(ConsistencyOptions().Check());
  const auto refusal = [](const auto& change) {
    return RefusalOf<ConsistencyOptions>(change);
  };
  EXPECT_THAT(refusal([](auto* o) { o->patch_radius = 0; }),
              HasSubstr("patch_radius = 0: must be in 1 .. 4"));
  EXPECT_THAT(refusal([](auto* o) { o->patch_radius = 5; }),
              HasSubstr("patch_radius"));
  EXPECT_THAT(refusal([](auto* o) { o->min_patch_pixels = -1; }),
              HasSubstr("min_patch_pixels = -1: must be in 0 .. 64"));
  EXPECT_THAT(refusal([](auto* o) { o->neutral = 1.5; }),
              HasSubstr("neutral = 1.5: must be in 0 .. 1"));
  EXPECT_THAT(refusal([](auto* o) { o->neutral = std::nan(""); }),
              HasSubstr("neutral"));
  EXPECT_THAT(refusal([](auto* o) { o->pixel_noise = 0; }),
              HasSubstr("pixel_noise = 0: must be positive"));
  EXPECT_THAT(refusal([](auto* o) { o->pixel_noise = 65; }),
              HasSubstr("pixel_noise"));
  EXPECT_THAT(refusal([](auto* o) { o->chroma_weight = 9; }),
              HasSubstr("chroma_weight = 9: must be in 0 .. 8"));
}

// A voxel covers some 1.5 pixels here.
TEST(PhotoConsistency, PatchesGrowUntilTheySpanEnoughPixels) {
  const SphereScene sphere = MakeSphereScene();
  const float voxel = 1.0f / (1 << SphereScene::kLevel);
  double pixels = 0;
  for (const PreparedView& view : sphere.test.views) {
    pixels += view.projection.CenterFootprint(voxel) /
              double(sphere.test.views.size());
  }
  ASSERT_GT(pixels, 1.0);
  ConsistencyOptions small;
  small.patch_radius = 1;
  small.min_patch_pixels = 0;
  ConsistencyOptions large = small;
  large.patch_radius = 3;
  ConsistencyOptions grown = small;
  grown.min_patch_pixels = 5.5 * pixels;
  const std::vector<float> phi = sphere.Estimate(grown).phi;
  EXPECT_EQ(phi, sphere.Estimate(large).phi);
  EXPECT_NE(phi, sphere.Estimate(small).phi);
  grown.min_patch_pixels = 1.9 * pixels;
  EXPECT_EQ(sphere.Estimate(grown).phi, sphere.Estimate(small).phi);
}

}  // namespace
}  // namespace octacut
