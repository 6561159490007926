#include "core/refine/offset_search.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kOffsetGrain = 256;
// A second peak as high as this share of the best one makes it ambiguous.
constexpr float kMaxSecondPeak = 0.93f;
// Keeps the weight of perfect agreement finite.
constexpr float kScoreSlack = 0.05f;
// Standard deviation of an offset at the views' own scale: what shape and gloss
// leave even where all views agree, and the part of their noise; as measured
// on three scenes with a truth (docs/experiments/refinement_weights.md).
constexpr float kLeastDeviation = 0.1f;  // pixels
constexpr float kNoise = 0.4f;
// The largest weight in coarser rounds.
constexpr float kMaxCoarseWeight = 12;
constexpr float kCoarsePrecision = 19;

// Whether a maximum other than scores[best] is nearly as high.
bool IsAmbiguous(const std::vector<float>& scores, size_t best) {
  for (size_t k = 1; k + 1 < scores.size(); ++k) {
    if (k != best && scores[k] >= scores[k - 1] && scores[k] >= scores[k + 1] &&
        scores[k] > kMaxSecondPeak * scores[best]) {
      return true;
    }
  }
  return false;
}

// What an offset is worth whose score is `lack` short of 1 and bends by
// `sharpness` (1 / pixels^2), for views whose weights come to `num_views`.
float WeightOfPeak(float lack,
                   float sharpness,
                   float num_views,
                   const OffsetSearch& search) {
  const float blur = (std::max(0.0f, lack) + kScoreSlack) / sharpness;
  if (search.spacing > 1) {
    // Large samples have no noise for more views to average, and what few views
    // see is off by most.
    return std::min(kMaxCoarseWeight, kCoarsePrecision / blur);
  }
  return 1 / std::hypot(kLeastDeviation, kNoise * blur / num_views);
}

// The top of the parabola through the best score and its neighbours.
OffsetMeasurement FindPeak(const std::vector<float>& scores,
                           const OffsetSearch& search,
                           float num_views,
                           float pixel) {
  const size_t middle = scores.size() / 2;
  OffsetMeasurement measurement;
  measurement.score_before = scores[middle];
  const size_t best =
      size_t(std::max_element(scores.begin(), scores.end()) - scores.begin());
  if (best == 0 || best + 1 == scores.size() ||
      scores[best] < float(search.min_score) || IsAmbiguous(scores, best)) {
    return measurement;
  }
  const float before = scores[best - 1];
  const float after = scores[best + 1];
  const float curvature = 2 * scores[best] - before - after;
  if (!(curvature > 0)) {
    return measurement;
  }
  const float step = float(search.step);
  const float peak = 0.5f * (after - before) / curvature;
  const float score = scores[best] + 0.25f * (after - before) * peak;
  measurement.offset = (float(best) - float(middle) + peak) * step * pixel;
  measurement.weight =
      WeightOfPeak(1 - score, curvature / (2 * step * step), num_views, search);
  return measurement;
}

// Scores of the patch at steps -half .. half. Every other score is only the
// mean of the two beside it, except for offset 0 and next to the best one.
void ScoreOffsets(int half,
                  float step,
                  SurfacePatch* patch,
                  std::vector<float>* scores) {
  const auto score = [&](int k) {
    (*scores)[size_t(k)] = patch->Score(float(k - half) * step);
  };
  const int last = 2 * half;
  int best = 0;
  for (int k = 0; k <= last; k += 2) {
    score(k);
    best = (*scores)[size_t(k)] > (*scores)[size_t(best)] ? k : best;
  }
  for (int k = 1; k < last; k += 2) {
    if (k == half || std::abs(k - best) == 1) {
      score(k);
    } else {
      const auto at = size_t(k);
      (*scores)[at] = 0.5f * ((*scores)[at - 1] + (*scores)[at + 1]);
    }
  }
}

}  // namespace

OffsetSearch MakeOffsetSearch(const RefineOptions& options,
                              double range,
                              double scale) {
  return {.range = range * scale,
          .step = RefineOptions::kStep * scale,
          .spacing = scale,
          .min_score = RefineOptions::kMinScore,
          .patch = options.patch};
}

std::vector<OffsetMeasurement> SearchOffsets(
    const ViewSet& views,
    const std::vector<LocalSurface>& surfaces,
    const std::vector<ChosenViews>& choices,
    const OffsetSearch& search,
    const Context& context,
    Phase* phase) {
  std::vector<OffsetMeasurement> measurements(surfaces.size());
  const int half = int(std::lround(search.range / search.step));
  ParallelFor(
      context, surfaces.size(), kOffsetGrain, [&](size_t begin, size_t end) {
        SurfacePatch patch(views, search.patch);
        std::vector<float> scores(2 * size_t(half) + 1);
        for (size_t i = begin; i < end; ++i) {
          const LocalSurface& surface = surfaces[i];
          const ChosenViews& chosen = choices[i];
          if (chosen.count < 2) {
            continue;
          }
          patch.MoveTo(surface, chosen, float(search.spacing) * chosen.pixel);
          if (patch.NumViews() < 2) {
            continue;
          }
          ScoreOffsets(
              half, float(search.step) * chosen.pixel, &patch, &scores);
          measurements[i] =
              FindPeak(scores, search, patch.SumOfWeights(), chosen.pixel);
          measurements[i].is_measured = true;
          measurements[i].mattness = patch.Mattness();
        }
        phase->Advance(end - begin);
      });
  return measurements;
}

}  // namespace octacut
