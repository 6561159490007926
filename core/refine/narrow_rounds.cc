#include "core/refine/narrow_rounds.h"

#include "core/base/stopwatch.h"
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

struct Pass {
  RoundPlan plan;  // of each of its rounds
  int num_rounds;
};

// Runs the rounds, and takes back what gains nothing. Returns the share of the
// moves that is kept.
double RunPass(const RoundInputs& inputs,
               const Pass& pass,
               const Context& context,
               ViewSet* views,
               IndexedMesh* mesh,
               std::vector<RoundSummary>* rounds) {
  const AgreementInputs agreeing{
      *views, inputs.neighbors, inputs.pixel, inputs.options};
  const std::vector<Eigen::Vector3d> before = mesh->positions;
  double seconds = 0;
  const SurfaceAgreement agreement = Timed(
      &seconds, [&] { return MeasureAgreement(agreeing, context, mesh); });
  for (int i = 0; i < pass.num_rounds; ++i) {
    rounds->push_back(
        RefineOnce(inputs, pass.plan, nullptr, context, views, mesh));
  }
  RoundSummary& last = rounds->back();
  last.agreement_seconds = seconds;
  last.taken_back = Timed(&last.agreement_seconds, [&] {
    return KeepGains(agreeing, before, agreement, context, mesh);
  });
  last.num_withdrawn += Timed(&last.validity_seconds, [&] {
    return KeepValid(*views,
                     inputs.neighbors,
                     {inputs.start, before, last.MaskTolerance(), inputs.pixel},
                     context,
                     mesh);
  });
  return 1 - last.taken_back;
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
  const RoundInputs narrow{
      inputs.start, inputs.neighbors, inputs.pixel, options};
  plan.range = options.range;
  double gaining = RunPass(narrow, {plan, 1}, context, views, mesh, rounds);
  plan.range *= kLaterRange;
  for (int pass = 1; pass < kMaxPasses && gaining >= kMinGainingShare; ++pass) {
    gaining =
        RunPass(narrow, {plan, kLaterRounds}, context, views, mesh, rounds);
  }
}

}  // namespace octacut
