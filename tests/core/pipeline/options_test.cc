#include "core/pipeline/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/pipeline/level_step.h"
#include "core/pipeline/reconstruct.h"
#include "tests/core/base/error_texts.h"

namespace octacut {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using Change = std::function<void(ReconstructionOptions*)>;

std::string Refusal(const Change& change) {
  return RefusalOf<ReconstructionOptions>(change);
}

TEST(ReconstructionOptions, HaveThePapersValuesAsDefaults) {
  const ReconstructionOptions options;
  EXPECT_NO_THROW(options.Check());
  EXPECT_EQ(options.hull.hull_level, 7);
  EXPECT_EQ(options.target_level, 9);
  EXPECT_EQ(options.crust.crust_dilation, 2);
  EXPECT_EQ(options.energy.smoothness, 4);
  EXPECT_EQ(options.energy.area_weight, 1e-5);
  EXPECT_EQ(options.consistency.measure,
            ConsistencyMeasure::kNormalizedVariance);
}

// Every step's options are checked, by its own rules.
TEST(ReconstructionOptions, AreRejectedWithFieldValueAndConstraint) {
  EXPECT_THAT(Refusal([](auto* o) { o->target_level = 6; }),
              AllOf(StartsWith("target_level = 6"), HasSubstr("hull_level")));
  EXPECT_THAT(Refusal([](auto* o) { o->target_level = 13; }),
              AllOf(StartsWith("target_level = 13"), HasSubstr("12")));
  EXPECT_THAT(Refusal([](auto* o) { o->finish.min_component = 1.5; }),
              AllOf(StartsWith("min_component = 1.5"), HasSubstr("0 .. 1")));
  EXPECT_THAT(Refusal([](auto* o) { o->finish.min_handle = 65; }),
              AllOf(StartsWith("min_handle = 65"), HasSubstr("0 .. 64")));
  EXPECT_THAT(Refusal([](auto* o) { o->max_grow_rounds = -1; }),
              AllOf(StartsWith("max_grow_rounds = -1"), HasSubstr("16")));
  EXPECT_THAT(Refusal([](auto* o) { o->energy.smoothness = 0; }),
              AllOf(StartsWith("smoothness = 0"), HasSubstr("positive")));
  EXPECT_THAT(Refusal([](auto* o) { o->energy.area_weight = 0; }),
              AllOf(StartsWith("area_weight = 0"), HasSubstr("1e-12")));
  EXPECT_THAT(
      Refusal([](auto* o) { o->energy.silhouette_weight = -1; }),
      AllOf(StartsWith("silhouette_weight = -1"), HasSubstr("0 .. 100")));
  EXPECT_THAT(Refusal([](auto* o) { o->hull.hull_level = 1; }),
              StartsWith("hull_level = 1"));
  EXPECT_THAT(Refusal([](auto* o) { o->crust.crust_dilation = 0; }),
              StartsWith("crust_dilation = 0"));
  EXPECT_THAT(Refusal([](auto* o) { o->visibility.max_views = 1; }),
              StartsWith("max_views = 1"));
  EXPECT_THAT(Refusal([](auto* o) { o->consistency.patch_radius = 9; }),
              StartsWith("patch_radius = 9"));
  EXPECT_THAT(Refusal([](auto* o) { o->evidence.ballooning = -1; }),
              StartsWith("ballooning = -1"));
  EXPECT_THAT(Refusal([](auto* o) { o->evidence.min_agreeing_views = 5; }),
              AllOf(StartsWith("min_agreeing_views = 5"),
                    HasSubstr("num_neighbors = 4")));
  EXPECT_THAT(Refusal([](auto* o) { o->evidence.sweep.num_neighbors = 1; }),
              StartsWith("depth_sweep.num_neighbors = 1"));
  EXPECT_NE(Refusal([](auto* o) { o->finish.smoothing.iterations = -1; }),
            "accepted");
  EXPECT_THAT(Refusal([](auto* o) { o->refinement.smoothness = 0; }),
              StartsWith("refinement.smoothness = 0"));
  EXPECT_THAT(Refusal([](auto* o) { o->refinement.views.max_angle = 90; }),
              StartsWith("refinement.max_angle = 90"));
  const double nan = std::nan("");
  EXPECT_NE(Refusal([&](auto* o) { o->energy.smoothness = nan; }), "accepted");
  EXPECT_NE(Refusal([&](auto* o) { o->energy.area_weight = nan; }), "accepted");
  EXPECT_NE(Refusal([&](auto* o) { o->finish.min_component = nan; }),
            "accepted");
}

TEST(ReconstructionOptions, AreCheckedBeforeAnythingElse) {
  ReconstructionOptions options;
  options.target_level = 20;
  EXPECT_THROW(Reconstruct(Scene(), Region(), options, Context(1)),
               OptionError);
}

}  // namespace
}  // namespace octacut
