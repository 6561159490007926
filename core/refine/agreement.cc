#include "core/refine/agreement.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/ramp.h"
#include "core/refine/offset_search.h"
#include "core/refine/point_rings.h"
#include "core/refine/seen_surface.h"

namespace octacut {
namespace {

constexpr size_t kAgreementGrain = 4096;
// Pixels between points: patches of 7 pixels overlap, and half as far takes
// more than twice as long for the same result.
constexpr double kSpacing = 4;
// Steps between neighbouring points within which a loss of agreement is
// averaged (docs/experiments/refinement_folds.md).
constexpr int kRings = 3;

// Losses of agreement from which on a move is taken back in part and as a
// whole, and gains from which on it is kept in part and as a whole.
struct Limits {
  float small;
  float large;
};
constexpr Limits kLosses = {0.02f, 0.05f};
constexpr Limits kGains = {0, 0.02f};

// For each point, how clearly the views agree more around it in `more` than in
// `less`, 0 .. 1.
std::vector<float> SharesOfRise(const SurfaceAgreement& less,
                                const SurfaceAgreement& more,
                                const Limits& limits,
                                const Look& look,
                                const Context& context) {
  // Patches overlap, so that the rises of so many points are one observation.
  const double width = 2 * look.options.patch.radius + 1;
  const double overlap = width * width / (kSpacing * kSpacing);
  std::vector<float> shares(less.scores.size(), 0);
  ParallelFor(
      context, shares.size(), kAgreementGrain, [&](size_t begin, size_t end) {
        PointRings rings(less.points.neighbors, shares.size());
        for (size_t i = begin; i < end; ++i) {
          double sum = 0;
          double squares = 0;
          double count = 0;
          rings.ForEach(uint32_t(i), 0, kRings, [&](uint32_t other) {
            if (less.is_measured[other] && more.is_measured[other]) {
              const double rise = more.scores[other] - less.scores[other];
              sum += rise;
              squares += rise * rise;
              ++count;
            }
          });
          if (count > 0) {
            // What scatters about no change is chance: what the mean surely
            // exceeds counts.
            const double mean = sum / count;
            const double variance =
                std::max(squares / count - mean * mean, 0.0);
            const double error = std::sqrt(variance * overlap / count);
            shares[i] = Ramp(float(mean - error), limits.small, limits.large);
          }
        }
      });
  return shares;
}

// Moves vertices back to `positions` by the shares of the points around.
TakenBack MoveBack(const std::vector<Eigen::Vector3d>& positions,
                   const SurfacePoints& points,
                   const std::vector<float>& shares,
                   const Look& look,
                   IndexedMesh* mesh) {
  TakenBack taken_back;
  taken_back.of_vertices.reserve(positions.size());
  double sum = 0;
  double count = 0;
  for (size_t v = 0; v < positions.size(); ++v) {
    // The mean of the points around keeps the moves smooth.
    const uint32_t own = points.point_of[v];
    float share = shares[own];
    for (const uint32_t next : points.neighbors.Of(own)) {
      share += shares[next];
    }
    share /= float(points.neighbors.Of(own).size() + 1);
    mesh->positions[v] += double(share) * (positions[v] - mesh->positions[v]);
    taken_back.of_vertices.push_back(share);
    if (look.part.empty() || look.part[v]) {
      sum += share;
      ++count;
    }
  }
  taken_back.mean = sum / std::max(count, 1.0);
  return taken_back;
}

SurfaceAgreement MeasureAt(SurfacePoints points,
                           const Look& look,
                           const Context& context,
                           IndexedMesh* mesh,
                           const char* phase_name = kAgreementPhase) {
  SeenSurface seen = LookAtPoints(std::move(points), look, context, mesh);
  Phase phase(context, phase_name, seen.surfaces.size());
  const OffsetSearch search = MakeOffsetSearch(look.options, 0, look.scale);
  SurfaceAgreement agreement;
  for (const OffsetMeasurement& measurement : SearchOffsets(
           look.views, seen.surfaces, seen.choices, search, context, &phase)) {
    agreement.scores.push_back(measurement.score_before);
    agreement.is_measured.push_back(measurement.is_measured);
    agreement.mattness.push_back(measurement.mattness);
  }
  for (const ChosenViews& chosen : seen.choices) {
    agreement.shown.push_back(std::accumulate(
        chosen.weights.begin(), chosen.weights.begin() + chosen.count, 0.0f));
  }
  agreement.points = std::move(seen.points);
  return agreement;
}

}  // namespace

double SurfaceAgreement::Mean() const {
  double sum = 0;
  double all = 0;
  for (size_t i = 0; i < scores.size(); ++i) {
    sum += is_measured[i] ? scores[i] * shown[i] : 0;
    all += shown[i];
  }
  return all > 0 ? sum / all : 0;
}

std::vector<float> SurfaceAgreement::MeansAround() const {
  PointRings rings(points.neighbors, scores.size());
  std::vector<float> means(scores.size(), kUnmeasured);
  for (size_t i = 0; i < scores.size(); ++i) {
    double sum = 0;
    double count = 0;
    rings.ForEach(uint32_t(i), 0, kRings, [&](uint32_t other) {
      sum += is_measured[other] ? scores[other] : 0;
      count += is_measured[other];
    });
    if (count > 0) {
      means[i] = float(sum / count);
    }
  }
  return means;
}

double SurfaceAgreement::UpperDecile() const {
  const std::vector<float> all = MeansAround();
  std::vector<float> means;
  for (size_t i = 0; i < all.size(); ++i) {
    if (is_measured[i]) {
      means.push_back(all[i]);
    }
  }
  if (means.empty()) {
    return 0;
  }
  const auto decile = means.begin() + ptrdiff_t(means.size() * 9 / 10);
  std::nth_element(means.begin(), decile, means.end());
  return *decile;
}

SurfaceAgreement MeasureAgreement(const Look& look,
                                  const Context& context,
                                  IndexedMesh* mesh,
                                  const char* phase) {
  return MeasureAt(
      SpreadPoints(*mesh, look.neighbors, kSpacing * look.scale * look.pixel),
      look,
      context,
      mesh,
      phase);
}

TakenBack TakeBackHarm(const Look& look,
                       const std::vector<Eigen::Vector3d>& positions,
                       const SurfaceAgreement& before,
                       const Context& context,
                       IndexedMesh* mesh) {
  const SurfaceAgreement after = MeasureAt(before.points, look, context, mesh);
  return MoveBack(positions,
                  after.points,
                  SharesOfRise(after, before, kLosses, look, context),
                  look,
                  mesh);
}

TakenBack KeepGains(const Look& look,
                    const std::vector<Eigen::Vector3d>& positions,
                    const SurfaceAgreement& before,
                    const Context& context,
                    IndexedMesh* mesh) {
  const SurfaceAgreement after = MeasureAt(before.points, look, context, mesh);
  std::vector<float> shares =
      SharesOfRise(before, after, kGains, look, context);
  for (float& share : shares) {
    share = 1 - share;
  }
  return MoveBack(positions, after.points, shares, look, mesh);
}

}  // namespace octacut
