#include "plugin/verdict_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/hull/visual_hull.h"

namespace octacut {
namespace {

// The share of the certain object pixels that may be missed: as many as
// smoothing takes from the tips of a good mesh.
constexpr double kMaxMissed = 0.001;
// The share of them that may be missed because components were removed.
constexpr double kMaxRemoved = 0.001;
// The share of the object's pixels that may be uncertain: a ring of one pixel
// around an object that is 400 pixels across.
constexpr double kMaxUnsure = 0.01;
constexpr double kMaxExceeded = 0.01;
// Pixels by which masks are too large or too small: less is how they are cut.
constexpr double kLargeShift = 1;
// The share of the missed pixels from which on this is their usual cause.
constexpr double kMost = 0.5;
// Shares of the surface.
constexpr double kMaxBlind = 0.05;
constexpr double kMaxUndecided = 0.1;
constexpr double kFewDecided = 0.5;
constexpr size_t kNamedViews = 3;

double Percent(size_t part, size_t whole) {
  return whole > 0 ? 100 * double(part) / double(whole) : 0;
}

bool IsMost(size_t part, size_t whole) {
  return double(part) >= kMost * double(whole);
}

// Numbers of the views with the largest `values`, those of 0 left out.
std::vector<size_t> Largest(const std::vector<double>& values) {
  std::vector<size_t> order(values.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return values[a] > values[b];
  });
  order.resize(std::min(order.size(), kNamedViews));
  std::erase_if(order, [&](size_t i) { return values[i] <= 0; });
  return order;
}

// The names of those views, with their percentages where these are asked for.
std::string NameLargest(const std::vector<double>& values,
                        const std::vector<View>& views,
                        bool with_values) {
  std::string names;
  for (const size_t i : Largest(values)) {
    names += (names.empty() ? "" : ", ") + views[i].name;
    if (with_values) {
      names += fmt::format(" ({:.2f} %)", values[i]);
    }
  }
  return names;
}

std::string DescribeCounts(const PixelCounts& counts) {
  return fmt::format(
      "the mesh covers {:.2f} % of the object pixels in the masks. It leaves "
      "{:.2f} % uncovered at the masks' borders, where the masks are "
      "uncertain, and {:.2f} % farther inside. It covers background pixels "
      "that amount to {:.2f} % of the object pixels.",
      Percent(counts.covered, counts.object),
      Percent(counts.unsure, counts.object),
      Percent(counts.missed, counts.object),
      Percent(counts.exceeded, counts.object));
}

class Writer {
 public:
  Writer(const MeshVerdict& verdict, const std::vector<View>& views)
      : verdict_(verdict), views_(views) {}

  VerdictText Run() {
    DescribeMasks();
    WarnOfMissed();
    WarnOfRemoved();
    WarnOfBorders();
    if (verdict_.surface) {
      DescribeSurface(*verdict_.surface);
      WarnOfBlind(verdict_.surface->blind);
      WarnOfUndecided(*verdict_.surface);
    }
    text_.findings.push_back(
        text_.warnings.empty()
            ? std::string("Verdict: no problems found.")
            : fmt::format("Verdict: {} problem{} found; see the warning{}.",
                          text_.warnings.size(),
                          text_.warnings.size() == 1 ? "" : "s",
                          text_.warnings.size() == 1 ? "" : "s"));
    return std::move(text_);
  }

 private:
  void DescribeMasks() {
    const PixelCounts& given = verdict_.given_masks.total;
    const PixelCounts& repaired = verdict_.repaired_masks.total;
    const bool is_repaired = given.object != repaired.object;
    text_.findings.push_back(
        fmt::format("Silhouettes{}: {}",
                    is_repaired ? " of the repaired masks" : "",
                    DescribeCounts(repaired)));
    if (is_repaired) {
      text_.findings.push_back("Silhouettes of the original masks: " +
                               DescribeCounts(given));
    }
  }

  void WarnOfMissed() {
    const MaskCheck& check = verdict_.repaired_masks;
    const PixelCounts& total = check.total;
    if (double(total.missed) <= kMaxMissed * double(total.Sure())) {
      return;
    }
    std::vector<double> shares;
    for (const PixelCounts& counts : check.views) {
      shares.push_back(Percent(counts.missed, counts.Sure()));
    }
    text_.warnings.push_back(
        fmt::format("The mesh does not cover {:.2f} % of the certain object "
                    "pixels, most of them in {}.{}",
                    Percent(total.missed, total.Sure()),
                    NameLargest(shares, views_, true),
                    HelpForMissed(check)));
  }

  std::string HelpForMissed(const MaskCheck& check) const {
    const PixelCounts& total = check.total;
    if (IsMost(total.contradicted, total.missed)) {
      const std::string suspects = NameLargest(
          {check.denied_of_others.begin(), check.denied_of_others.end()},
          views_,
          false);
      return fmt::format(
          " The masks contradict each other: for {:.0f} % of these pixels, "
          "other masks show background along the whole viewing ray.{}",
          Percent(total.contradicted, total.missed),
          suspects.empty() ? std::string()
                           : " Check the masks of " + suspects + ".");
    }
    if (verdict_.hull_level > 0 &&
        verdict_.hull_level < VisualHullOptions::kMaxLevel &&
        IsMost(verdict_.num_thin_pixels, total.missed)) {
      return fmt::format(
          " Most of them are in structures thinner than three voxels of the "
          "visual hull (level {}); --OctahedralMeshing.hull_level {} may keep "
          "these.",
          verdict_.hull_level,
          verdict_.hull_level + 1);
    }
    return "";
  }

  void WarnOfRemoved() {
    const std::vector<double> pixels(verdict_.removed_pixels.begin(),
                                     verdict_.removed_pixels.end());
    const double sum = std::accumulate(pixels.begin(), pixels.end(), 0.0);
    if (sum > kMaxRemoved * double(verdict_.repaired_masks.total.Sure())) {
      text_.warnings.push_back(fmt::format(
          "Small components were removed. Therefore {} certain object pixels, "
          "most of them in {}, are not covered. A smaller `min_component` of "
          "octahedral_mesher keeps these components.",
          sum,
          NameLargest(pixels, views_, false)));
    }
  }

  void WarnOfBorders() {
    const PixelCounts& repaired = verdict_.repaired_masks.total;
    if (verdict_.border_shift >= kLargeShift &&
        double(repaired.unsure) > kMaxUnsure * double(repaired.object)) {
      text_.warnings.push_back(fmt::format(
          "The photographs indicate that the masks are {:.1f} pixels too "
          "large, and {:.2f} % of the object pixels are left uncovered for "
          "this reason. If the masks are correct, use "
          "--OctahedralMeshing.move_mask_borders 0.",
          verdict_.border_shift,
          Percent(repaired.unsure, repaired.object)));
    }
    const MaskCheck& given = verdict_.given_masks;
    if (double(given.total.surely_exceeded) >
        kMaxExceeded * double(given.total.object)) {
      std::vector<double> shares;
      for (const PixelCounts& counts : given.views) {
        shares.push_back(Percent(counts.surely_exceeded, counts.object));
      }
      text_.warnings.push_back(fmt::format(
          "The mesh extends beyond the original masks and their tolerance: it "
          "covers background pixels that amount to {:.2f} % of the object "
          "pixels. Check the masks of {}.",
          Percent(given.total.surely_exceeded, given.total.object),
          NameLargest(shares, views_, true)));
    }
  }

  void DescribeSurface(const SurfaceSupport& surface) {
    text_.findings.push_back(
        fmt::format("Surface: {:.1f} % is determined by photographs, {:.1f} % "
                    "by silhouettes and {:.1f} % by neither. At least two "
                    "views see {:.1f} % of it; there, their mean agreement "
                    "is {:.2f} (1 is perfect; noise and highlights lower it).",
                    100 * surface.photographs,
                    100 * surface.silhouettes,
                    100 * surface.nothing,
                    100 * (1 - surface.blind.share),
                    surface.agreement));
  }

  void WarnOfBlind(const BlindPart& blind) {
    if (blind.share <= kMaxBlind) {
      return;
    }
    struct Direction {
      double share;
      const char* help;
    };
    const std::array<Direction, 5> directions = {{
        {blind.hidden, "that look into the concavities"},
        {blind.above, "from above"},
        {blind.below, "from below, or of the object turned over"},
        {blind.aside, "from the missing sides"},
        {ShareOfUnknown(blind), "of these parts"},
    }};
    const Direction& most =
        *std::max_element(directions.begin(),
                          directions.end(),
                          [](const Direction& a, const Direction& b) {
                            return a.share < b.share;
                          });
    text_.warnings.push_back(fmt::format(
        "Fewer than two views see {:.1f} % of the surface: {}. Add views {}{}.",
        100 * blind.share,
        DescribeBlind(blind),
        most.help,
        blind.nearest_view && most.share != blind.hidden
            ? "; the nearest existing view is " +
                  views_[*blind.nearest_view].name
            : std::string()));
  }

  // What no view hides, where the images have no common up.
  static double ShareOfUnknown(const BlindPart& blind) {
    return blind.above + blind.below + blind.aside > 0
               ? 0
               : blind.share - blind.hidden;
  }

  static std::string DescribeBlind(const BlindPart& blind) {
    const std::pair<double, const char*> parts[] = {
        {ShareOfUnknown(blind), "is faced by fewer than two views"},
        {blind.above, "faces upward in the images"},
        {blind.below, "faces downward in the images"},
        {blind.aside, "faces sideways"},
        {blind.hidden, "is hidden by the object itself"},
    };
    std::vector<std::string> described;
    for (const auto& [share, where] : parts) {
      if (share >= 0.0005) {
        described.push_back(fmt::format("{:.1f} % {}", 100 * share, where));
      }
    }
    return fmt::format("{}", fmt::join(described, ", "));
  }

  void WarnOfUndecided(const SurfaceSupport& surface) {
    const double seen = 1 - surface.blind.share;
    if (surface.photographs < kFewDecided * seen) {
      text_.warnings.push_back(fmt::format(
          "Photographs determine only {:.0f} % of the visible surface: it is "
          "untextured or shiny, or the photographs are blurred. Elsewhere the "
          "mesh follows the silhouettes, which do not show concavities: a bowl "
          "may be filled to its rim. Diffuse light, a matt coating or a "
          "sprayed pattern helps.",
          seen > 0 ? 100 * surface.photographs / seen : 0));
    }
    if (surface.nothing > kMaxUndecided) {
      text_.warnings.push_back(fmt::format(
          "Neither photographs nor silhouettes determine {:.0f} % of the "
          "surface. It may be wrong there by more than a voxel. More views of "
          "these parts, diffuse light or a matt coating may help.",
          100 * surface.nothing));
    }
  }

  const MeshVerdict& verdict_;
  const std::vector<View>& views_;
  VerdictText text_;
};

}  // namespace

VerdictText DescribeVerdict(const MeshVerdict& verdict,
                            const std::vector<View>& views) {
  return Writer(verdict, views).Run();
}

void ReportVerdict(const VerdictText& text, const Context& context) {
  for (const std::string& finding : text.findings) {
    context.Info(finding);
  }
  for (const std::string& warning : text.warnings) {
    context.Warn(warning);
  }
}

}  // namespace octacut
