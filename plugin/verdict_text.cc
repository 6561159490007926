#include "plugin/verdict_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace octacut {
namespace {

// Of the pixels that are surely object: as many as a good mesh leaves uncovered
// at thin edges, where it is smoothed.
constexpr double kMaxMissed = 0.001;
constexpr size_t kNamedViews = 3;
// Of the missed pixels: from this share on the masks are to blame.
constexpr double kMostlyContradicted = 0.5;

double Percent(size_t part, size_t whole) {
  return whole > 0 ? 100 * double(part) / double(whole) : 0;
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

std::string Names(const std::vector<size_t>& numbers,
                  const std::vector<View>& views) {
  std::string names;
  for (const size_t i : numbers) {
    names += (names.empty() ? "" : ", ") + views[i].name;
  }
  return names;
}

std::string DescribeCounts(const PixelCounts& counts) {
  return fmt::format(
      "the mesh covers {:.2f} % of the object's pixels; {:.2f} % are uncovered "
      "at the masks' borders, where these are unsure, and {:.2f} % farther "
      "inside. It exceeds the masks by {:.2f} %",
      Percent(counts.covered, counts.object),
      Percent(counts.unsure, counts.object),
      Percent(counts.missed, counts.object),
      Percent(counts.exceeded, counts.object));
}

void ReportMasks(const MeshVerdict& verdict, const Context& context) {
  const bool is_repaired =
      verdict.given_masks.total.object != verdict.repaired_masks.total.object;
  context.Info(fmt::format("silhouettes{}: {}",
                           is_repaired ? " with filled gaps" : "",
                           DescribeCounts(verdict.repaired_masks.total)));
  if (is_repaired) {
    context.Info(fmt::format("silhouettes as given: {}",
                             DescribeCounts(verdict.given_masks.total)));
  }
}

void WarnOfMissed(const MaskCheck& check,
                  const std::vector<View>& views,
                  const Context& context) {
  const PixelCounts& total = check.total;
  if (double(total.missed) <= kMaxMissed * double(total.Sure())) {
    return;
  }
  std::vector<double> shares;
  for (const PixelCounts& counts : check.views) {
    shares.push_back(Percent(counts.missed, counts.Sure()));
  }
  std::string worst;
  for (const size_t i : Largest(shares)) {
    worst += fmt::format(
        "{}{} ({:.2f} %)", worst.empty() ? "" : ", ", views[i].name, shares[i]);
  }
  context.Warn(
      fmt::format("the mesh leaves {:.2f} % of the pixels uncovered that are "
                  "surely object, "
                  "most in {}",
                  Percent(total.missed, total.Sure()),
                  worst));
  if (double(total.contradicted) < kMostlyContradicted * double(total.missed)) {
    return;
  }
  const std::vector<size_t> suspects =
      Largest({check.denied_of_others.begin(), check.denied_of_others.end()});
  context.Warn(fmt::format(
      "the masks contradict each other: no object covers {:.0f} % of those "
      "pixels, since other masks show background there{}",
      Percent(total.contradicted, total.missed),
      suspects.empty()
          ? std::string()
          : "; the masks to look at are those of " + Names(suspects, views)));
}

void WarnOfRemoved(const MeshVerdict& verdict,
                   const std::vector<View>& views,
                   const Context& context) {
  const std::vector<double> pixels(verdict.removed_pixels.begin(),
                                   verdict.removed_pixels.end());
  const std::vector<size_t> worst = Largest(pixels);
  if (worst.empty()) {
    return;
  }
  context.Warn(fmt::format(
      "parts that were removed for being small (min_component) leave {} pixels "
      "uncovered that are surely object, most in {}; a smaller min_component "
      "keeps them",
      std::accumulate(pixels.begin(), pixels.end(), 0.0),
      Names(worst, views)));
}

}  // namespace

void ReportVerdict(const MeshVerdict& verdict,
                   const std::vector<View>& views,
                   const Context& context) {
  ReportMasks(verdict, context);
  WarnOfMissed(verdict.repaired_masks, views, context);
  WarnOfRemoved(verdict, views, context);
}

}  // namespace octacut
