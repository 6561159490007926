#include "core/refine/narrow_rounds.h"

#include <cmath>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/mesh/mean_edge.h"
#include "core/refine/agreement.h"
#include "core/refine/keep_valid.h"

namespace octacut {
namespace {

// In place of those of RefineOptions: pieces of 6 pixels radius hold a patch of
// 7 x 7 samples; smaller ones, and more smoothness, gain less.
constexpr double kNarrowFitRadius = 6;
constexpr double kNarrowSmoothness = 4;
// The first pass tells whether there is much to gain. Later ones search
// farther: the bottoms of folds lie far behind what closes them.
constexpr int kMaxPasses = 4;
constexpr int kLaterRounds = 2;
constexpr double kLaterRange = 2;  // times that of the first pass
// No pass follows one after which less than this share of the moves was kept,
// nor the first a round in which less than this share of the points had
// offsets.
constexpr double kMinGainingShare = 0.1;
// Later passes look at what lies at most this far, in pixels, from vertices
// that kept more than half of their moves: where pieces overlap with theirs.
constexpr double kReachOfGains = 2 * kNarrowFitRadius;

struct Pass {
  RoundPlan plan;  // of each of its rounds
  int num_rounds;
};

// Runs the rounds, and takes back what gains nothing.
TakenBack RunPass(const RoundInputs& inputs,
                  const Pass& pass,
                  const Context& context,
                  ViewSet* views,
                  IndexedMesh* mesh,
                  std::vector<RoundSummary>* rounds) {
  const Look look{.views = *views,
                  .neighbors = inputs.neighbors,
                  .options = inputs.options,
                  .pixel = inputs.pixel,
                  .part = inputs.part};
  const std::vector<Eigen::Vector3d> before = mesh->positions;
  double seconds = 0;
  const SurfaceAgreement agreement =
      Timed(&seconds, [&] { return MeasureAgreement(look, context, mesh); });
  for (int i = 0; i < pass.num_rounds; ++i) {
    rounds->push_back(
        RefineOnce(inputs, pass.plan, nullptr, context, views, mesh));
  }
  RoundSummary& last = rounds->back();
  last.agreement_seconds = seconds;
  TakenBack taken_back = Timed(&last.agreement_seconds, [&] {
    return KeepGains(look, before, agreement, context, mesh);
  });
  last.taken_back = taken_back.mean;
  last.num_withdrawn += Timed(&last.validity_seconds, [&] {
    return KeepValid(*views,
                     inputs.neighbors,
                     {inputs.start, before, last.MaskTolerance(), inputs.pixel},
                     context,
                     mesh);
  });
  return taken_back;
}

// The part of the surface that the next pass looks at.
std::vector<uint8_t> PartAroundGains(const TakenBack& taken_back,
                                     const RoundInputs& inputs,
                                     const IndexedMesh& mesh) {
  std::vector<uint8_t> gained;
  gained.reserve(taken_back.of_vertices.size());
  for (const float share : taken_back.of_vertices) {
    gained.push_back(share < 0.5f);
  }
  const double reach = kReachOfGains * inputs.pixel / MeanEdge(mesh);
  return Dilate(std::move(gained), inputs.neighbors, int(std::ceil(reach)));
}

}  // namespace

void RefineNarrowParts(const RoundInputs& inputs,
                       RoundPlan plan,
                       const Context& context,
                       ViewSet* views,
                       IndexedMesh* mesh,
                       std::vector<RoundSummary>* rounds) {
  // Only where points have offsets can a pass gain.
  const RoundSummary& last = rounds->back();
  if (double(last.num_measured) < kMinGainingShare * double(last.num_seen)) {
    return;
  }
  RefineOptions options = inputs.options;
  options.fit_radius = kNarrowFitRadius;
  options.smoothness = kNarrowSmoothness;
  RoundInputs narrow{inputs.start, inputs.neighbors, inputs.pixel, options};
  plan.range = RefineOptions::kRange;
  TakenBack taken_back =
      RunPass(narrow, {plan, 1}, context, views, mesh, rounds);
  plan.range *= kLaterRange;
  std::vector<uint8_t> part;
  for (int pass = 1;
       pass < kMaxPasses && 1 - taken_back.mean >= kMinGainingShare;
       ++pass) {
    part = PartAroundGains(taken_back, narrow, *mesh);
    narrow.part = part;
    taken_back =
        RunPass(narrow, {plan, kLaterRounds}, context, views, mesh, rounds);
  }
}

}  // namespace octacut
