#include "plugin/verdict_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace octacut {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<View> ThreeViews() {
  std::vector<View> views(3);
  views[0].name = "a.jpg";
  views[1].name = "b.jpg";
  views[2].name = "c.jpg";
  return views;
}

void SumUp(MaskCheck* check) {
  check->total = PixelCounts();
  for (const PixelCounts& view : check->views) {
    check->total += view;
  }
}

MeshVerdict GoodVerdict() {
  MeshVerdict verdict;
  PixelCounts view;
  view.object = 1000;
  view.border = 20;
  view.covered = 995;
  view.unsure = 5;
  view.exceeded = 1;
  verdict.repaired_masks.views.assign(3, view);
  verdict.repaired_masks.denied_of_others.assign(3, 0);
  SumUp(&verdict.repaired_masks);
  verdict.given_masks = verdict.repaired_masks;
  verdict.removed_pixels.assign(3, 0);
  verdict.hull_level = 7;
  SurfaceSupport& surface = verdict.surface.emplace();
  surface.photographs = 0.9;
  surface.silhouettes = 0.07;
  surface.nothing = 0.03;
  surface.agreement = 0.5;
  surface.blind.share = surface.blind.below = 0.02;
  return verdict;
}

// `missed` pixels of each view.
MeshVerdict WithMissed(const std::vector<size_t>& missed) {
  MeshVerdict verdict = GoodVerdict();
  for (size_t i = 0; i < missed.size(); ++i) {
    verdict.repaired_masks.views[i].missed = missed[i];
    verdict.repaired_masks.views[i].covered -= missed[i];
  }
  SumUp(&verdict.repaired_masks);
  verdict.given_masks = verdict.repaired_masks;
  return verdict;
}

std::vector<std::string> WarningsOf(const MeshVerdict& verdict) {
  return DescribeVerdict(verdict, ThreeViews()).warnings;
}

TEST(VerdictText, SaysWhatAGoodMeshRestsOn) {
  const VerdictText text = DescribeVerdict(GoodVerdict(), ThreeViews());
  EXPECT_THAT(text.warnings, IsEmpty());
  EXPECT_THAT(
      text.findings,
      ElementsAre(AllOf(HasSubstr("covers 99.50 %"),
                        HasSubstr("leaves 0.50 % uncovered"),
                        HasSubstr("pixels that amount to 0.10 % of")),
                  AllOf(HasSubstr("90.0 % is determined by photographs"),
                        HasSubstr("7.0 % by silhouettes and 3.0 % by neither"),
                        HasSubstr("two views see 98.0 %")),
                  HasSubstr("no problems found")));
}

TEST(VerdictText, SaysBothWhereMasksWereRepaired) {
  MeshVerdict verdict = GoodVerdict();
  verdict.given_masks.total.object -= 100;
  verdict.given_masks.total.covered -= 100;
  verdict.given_masks.total.exceeded += 100;
  EXPECT_THAT(DescribeVerdict(verdict, ThreeViews()).findings,
              Contains(AllOf(HasSubstr("Silhouettes of the original masks"),
                             HasSubstr("pixels that amount to 3.55 % of"))));
}

TEST(VerdictText, NamesTheWorstViewsFirst) {
  EXPECT_THAT(WarningsOf(WithMissed({0, 4, 0})), Not(IsEmpty()));
  EXPECT_THAT(WarningsOf(WithMissed({0, 2, 0})), IsEmpty());
  EXPECT_THAT(WarningsOf(WithMissed({10, 49, 0})),
              ElementsAre(AllOf(
                  HasSubstr("does not cover 2.01 % of the certain object"),
                  HasSubstr("b.jpg (5.00 %), a.jpg (1.02 %)"),
                  Not(HasSubstr("c.jpg")),
                  Not(HasSubstr("hull_level")))));
}

TEST(VerdictText, SuggestsAFinerHullForThinParts) {
  MeshVerdict verdict = WithMissed({10, 50, 0});
  verdict.num_thin_pixels = 40;
  EXPECT_THAT(WarningsOf(verdict),
              ElementsAre(HasSubstr("--OctahedralMeshing.hull_level 8")));
}

TEST(VerdictText, NamesTheMasksThatContradictOthers) {
  MeshVerdict verdict = WithMissed({10, 50, 0});
  verdict.repaired_masks.total.contradicted = 50;
  verdict.repaired_masks.denied_of_others = {0, 0, 45};
  EXPECT_THAT(WarningsOf(verdict),
              ElementsAre(AllOf(HasSubstr("masks contradict each other"),
                                HasSubstr("Check the masks of c.jpg"))));
}

TEST(VerdictText, SaysWhatMinComponentHasTaken) {
  MeshVerdict verdict = GoodVerdict();
  verdict.removed_pixels = {0, 2, 0};
  EXPECT_THAT(WarningsOf(verdict), IsEmpty());
  verdict.removed_pixels = {0, 7, 0};
  EXPECT_THAT(WarningsOf(verdict),
              ElementsAre(AllOf(HasSubstr("7 certain object pixels"),
                                HasSubstr("most of them in b.jpg"),
                                HasSubstr("min_component"))));
}

TEST(VerdictText, AsksAboutMasksThatAreTakenToBeTooLarge) {
  MeshVerdict verdict = GoodVerdict();
  verdict.repaired_masks.total.unsure = 90;
  EXPECT_THAT(WarningsOf(verdict), IsEmpty());
  verdict.border_shift = 3;
  EXPECT_THAT(WarningsOf(verdict),
              ElementsAre(AllOf(HasSubstr("3.0 pixels too large"),
                                HasSubstr("move_mask_borders 0"))));
}

TEST(VerdictText, NamesMasksThatTheMeshExceeds) {
  MeshVerdict verdict = GoodVerdict();
  verdict.given_masks.views[2].surely_exceeded = 200;
  SumUp(&verdict.given_masks);
  EXPECT_THAT(WarningsOf(verdict),
              ElementsAre(AllOf(HasSubstr("extends beyond the original masks"),
                                HasSubstr("c.jpg (20.00 %)"))));
}

TEST(VerdictText, SaysFromWhereViewsAreMissing) {
  MeshVerdict verdict = GoodVerdict();
  BlindPart& blind = verdict.surface->blind;
  blind.share = 0.2;
  blind.below = 0.15;
  blind.hidden = 0.05;
  blind.nearest_view = 1;
  EXPECT_THAT(WarningsOf(verdict),
              ElementsAre(AllOf(HasSubstr("see 20.0 % of the surface"),
                                HasSubstr("views from below"),
                                HasSubstr("nearest existing view is b.jpg"))));
  blind.below = 0.05;
  blind.hidden = 0.15;
  EXPECT_THAT(WarningsOf(verdict),
              ElementsAre(AllOf(HasSubstr("look into the concavities"),
                                Not(HasSubstr("b.jpg")))));
}

TEST(VerdictText, SaysNotWhereUpIsIfImagesHaveNoCommonUp) {
  MeshVerdict verdict = GoodVerdict();
  BlindPart& blind = verdict.surface->blind;
  blind.share = 0.2;
  blind.below = 0;
  blind.hidden = 0.05;
  blind.nearest_view = 1;
  EXPECT_THAT(
      WarningsOf(verdict),
      ElementsAre(AllOf(HasSubstr("15.0 % is faced by fewer than two views, "
                                  "5.0 % is hidden"),
                        HasSubstr("views of these parts"),
                        HasSubstr("nearest existing view is b.jpg"))));
}

TEST(VerdictText, SaysWhereLightWouldHelp) {
  MeshVerdict verdict = GoodVerdict();
  verdict.surface->photographs = 0.3;
  verdict.surface->silhouettes = 0.65;
  verdict.surface->nothing = 0.05;
  EXPECT_THAT(WarningsOf(verdict),
              ElementsAre(AllOf(HasSubstr("determine only 31 %"),
                                HasSubstr("filled to its rim"),
                                HasSubstr("Diffuse light"))));
  verdict.surface->nothing = 0.2;
  EXPECT_THAT(WarningsOf(verdict),
              Contains(HasSubstr("Neither photographs nor silhouettes")));
}

}  // namespace
}  // namespace octacut
