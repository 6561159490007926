#include "core/consistency/photo_consistency.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/consistency/patch.h"

namespace octacut {
namespace {

constexpr size_t kBrickGrain = 64;

struct WeightedVariance {
  float total_weight = 0;  // W
  float mean_reliability = 0;
  float variance = 0;         // equation (1)
  float effective_views = 0;  // W^2 / sum w^2
};

WeightedVariance VarianceOverViews(const Patch& patch) {
  WeightedVariance result;
  float squared_weights = 0;
  for (int j = 0; j < patch.NumViews(); ++j) {
    const float weight = patch.View(j).weight;
    result.total_weight += weight;
    squared_weights += weight * weight;
    result.mean_reliability += weight * patch.View(j).reliability;
  }
  result.mean_reliability /= result.total_weight;
  result.effective_views =
      result.total_weight * result.total_weight / squared_weights;
  const float inverse_weight = 1 / result.total_weight;
  Float4 variance = {0, 0, 0, 0};
  for (int i = 0; i < patch.NumSamples(); ++i) {
    Float4 mean = {0, 0, 0, 0};
    Float4 mean_square = {0, 0, 0, 0};
    for (int j = 0; j < patch.NumViews(); ++j) {
      const Float4 color = patch.View(j).samples[i];
      const Float4 weighted = color * patch.View(j).weight;
      mean += weighted;
      mean_square += weighted * color;
    }
    mean *= inverse_weight;
    variance += mean_square * inverse_weight - mean * mean;  // HK06 eq. (1)
  }
  result.variance = SumChannels(variance);
  return result;
}

// Equation (1) on unit vectors is (1 - mean pairwise correlation) (m - 1) / m
// for m equally weighted views: the factor is taken out, so that phi means the
// same for any number of views. What the noise takes of the contrast pulls
// towards the neutral value.
float NormalizedVariance(Patch* patch, const ConsistencyOptions& options) {
  patch->Normalize(float(options.pixel_noise), float(options.chroma_weight));
  const WeightedVariance v = VarianceOverViews(*patch);
  const float unbiased =
      v.variance * v.effective_views / std::max(v.effective_views - 1, 0.5f);
  return unbiased + (1 - v.mean_reliability) * float(options.neutral);
}

float PairwiseCorrelation(Patch* patch, const ConsistencyOptions& options) {
  patch->Normalize(float(options.pixel_noise), float(options.chroma_weight));
  float sum = 0;
  float weights = 0;
  for (int j = 0; j < patch->NumViews(); ++j) {
    for (int k = 0; k < j; ++k) {
      Float4 product = {0, 0, 0, 0};
      for (int i = 0; i < patch->NumSamples(); ++i) {
        product += patch->View(j).samples[i] * patch->View(k).samples[i];
      }
      const float weight = patch->View(j).weight * patch->View(k).weight;
      sum += weight * SumChannels(product);
      weights += weight;
    }
  }
  // -1 .. 1 to 1 .. 0; a plain patch has correlation 0 and so 1/2.
  return 0.5f * (1 - sum / weights);
}

// The standard deviation over the views, 64 grey levels being as bad as it
// gets.
float PlainVariance(const Patch& patch) {
  constexpr float kLargestDeviation = 64;
  const WeightedVariance v = VarianceOverViews(patch);
  return std::sqrt(std::max(0.0f, v.variance) /
                   (3 * float(patch.NumSamples()))) /
         kLargestDeviation;
}

float Measure(Patch* patch, const ConsistencyOptions& options) {
  switch (options.measure) {
    case ConsistencyMeasure::kNormalizedVariance:
      return NormalizedVariance(patch, options);
    case ConsistencyMeasure::kNcc:
      return PairwiseCorrelation(patch, options);
    case ConsistencyMeasure::kVariance:
      return PlainVariance(*patch);
  }
  throw InvariantError("unknown photo-consistency measure");
}

// Distance and number of the samples of a patch.
struct PatchScale {
  float spacing;  // unit coordinates
  int radius;     // samples
};

// A voxel between samples, but at least a pixel of the average view at the
// cube's centre, and never a smaller patch than min_patch_pixels.
PatchScale ScaleOfPatches(const ViewSet& views,
                          float voxel,
                          const ConsistencyOptions& options) {
  double pixels_per_voxel = 0;
  for (const PreparedView& view : views) {
    pixels_per_voxel += view.projection.CenterFootprint(voxel);
  }
  pixels_per_voxel /= double(views.size());
  const double pixels = std::max(1.0, pixels_per_voxel);
  const int radius = int(std::ceil(options.min_patch_pixels / (2 * pixels)));
  return {float(pixels / pixels_per_voxel) * voxel,
          std::clamp(radius, options.patch_radius, Patch::kMaxRadius)};
}

struct ChunkSummary {
  size_t num_unseen = 0;
  double sum = 0;
};

}  // namespace

void ConsistencyOptions::Check() const {
  CheckOption(patch_radius >= 1 && patch_radius <= Patch::kMaxRadius,
              "patch_radius",
              patch_radius,
              "must be in 1 .. 4");
  CheckOption(min_patch_pixels >= 0 && min_patch_pixels <= 64,
              "min_patch_pixels",
              min_patch_pixels,
              "must be in 0 .. 64");
  CheckOption(
      neutral >= 0 && neutral <= 1, "neutral", neutral, "must be in 0 .. 1");
  CheckOption(pixel_noise > 0 && pixel_noise <= 64,
              "pixel_noise",
              pixel_noise,
              "must be positive and at most 64");
  CheckOption(chroma_weight >= 0 && chroma_weight <= 8,
              "chroma_weight",
              chroma_weight,
              "must be in 0 .. 8");
}

void ConsistencySummary::Add(const ConsistencySummary& other) {
  const size_t own_seen = num_voxels - num_unseen;
  const size_t other_seen = other.num_voxels - other.num_unseen;
  if (own_seen + other_seen > 0) {
    mean = (mean * double(own_seen) + other.mean * double(other_seen)) /
           double(own_seen + other_seen);
  }
  num_voxels += other.num_voxels;
  num_unseen += other.num_unseen;
}

PhotoConsistency EstimateConsistency(const ViewSet& views,
                                     const VoxelGrid& voxels,
                                     const std::vector<SurfaceShape>& shapes,
                                     const Visibility& visibility,
                                     const ConsistencyOptions& options,
                                     const Context& context) {
  options.Check();
  Phase phase(context,
              fmt::format("photo-consistency of level {}", voxels.Level()),
              voxels.Size());
  PhotoConsistency result;
  result.phi.resize(voxels.Size());
  result.is_seen.resize(voxels.Size());
  const PatchScale patches =
      ScaleOfPatches(views, 1.0f / float(voxels.Resolution()), options);
  std::vector<ChunkSummary> summaries(
      NumChunks(voxels.Bricks().size(), kBrickGrain));
  ParallelChunks(
      context,
      voxels.Bricks().size(),
      kBrickGrain,
      [&](size_t chunk, size_t begin, size_t end) {
        Patch patch;
        ChunkSummary summary;
        size_t count = 0;
        voxels.ForEachInBricks(
            begin, end, [&](VoxelGrid::Index index, MortonCode code) {
              ++count;
              const Eigen::Vector3f center =
                  VoxelCenter(DecodeMorton(code), voxels.Level());
              const SurfaceShape& shape = shapes[index];
              patch.Sample(views,
                           visibility.Select(center, shape.normal),
                           {center,
                            shape.normal,
                            shape.curvature * float(voxels.Resolution()),
                            patches.spacing,
                            patches.radius});
              if (patch.NumViews() < 2) {
                result.phi[index] = float(options.neutral);
                ++summary.num_unseen;
                return;
              }
              result.is_seen[index] = 1;
              result.phi[index] =
                  std::clamp(Measure(&patch, options), 0.0f, 1.0f);
              summary.sum += result.phi[index];
            });
        summaries[chunk] = summary;
        phase.Advance(count);
      });
  result.summary.num_voxels = voxels.Size();
  double sum = 0;
  for (const ChunkSummary& summary : summaries) {
    result.summary.num_unseen += summary.num_unseen;
    sum += summary.sum;
  }
  const size_t num_seen = voxels.Size() - result.summary.num_unseen;
  result.summary.mean = num_seen > 0 ? sum / double(num_seen) : 0;
  return result;
}

}  // namespace octacut
