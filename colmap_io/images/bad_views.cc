#include "colmap_io/images/bad_views.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace octacut {
namespace {

// At most one in so many of all views is left out.
constexpr size_t kMaxLeftOutDivisor = 10;

std::string Figures(const ViewFit& fit) {
  return fmt::format(
      "{:.1f} % of its object lies where the other masks allow none, and it "
      "excludes {:.1f} % of the object in the other masks",
      100 * fit.unexplained,
      100 * fit.taken);
}

std::string ListOf(const std::vector<BadView>& views) {
  std::string list;
  for (const BadView& view : views) {
    list += fmt::format("{}{} ({:.1f} %, {:.1f} %)",
                        list.empty() ? "" : ", ",
                        view.mask_file.string(),
                        100 * view.fit.unexplained,
                        100 * view.fit.taken);
  }
  return list;
}

void WarnOf(const BadView& view, const Context& context) {
  context.Warn(
      fmt::format("{}: this mask or the pose of {} contradicts the other "
                  "views: {}. The view is {}.",
                  view.mask_file.string(),
                  view.name,
                  Figures(view.fit),
                  view.is_left_out ? "left out; --keep_all_views 1 uses it"
                                   : "used nevertheless, because too many "
                                     "masks show more than the object"));
}

}  // namespace

BadViewSummary DecideOnBadViews(const Contradictions& contradictions,
                                const std::vector<JudgedView>& judged,
                                const Context& context) {
  BadViewSummary summary;
  summary.is_judged = contradictions.is_judged;
  summary.largest_left = contradictions.largest_left;
  const auto num_grave = size_t(std::count_if(
      contradictions.views.begin(),
      contradictions.views.end(),
      [](const ContradictingView& view) { return view.is_grave; }));
  const size_t num_bad = contradictions.views.size();
  const bool are_all_left_out = num_bad * kMaxLeftOutDivisor <= judged.size();
  for (const ContradictingView& bad : contradictions.views) {
    const JudgedView& view = judged[bad.view];
    summary.views.push_back(
        {view.name, view.mask_file, bad.fit, are_all_left_out || bad.is_grave});
  }
  if (num_grave * kMaxLeftOutDivisor > judged.size()) {
    throw InputError(fmt::format(
        "{} of {} views contradict the others, {} of them seriously, which is "
        "more than a tenth: {}. The percentages in brackets are the share of "
        "the mask's object that lies where the other masks allow none, and the "
        "share of the object in the other masks that this mask excludes. Such "
        "a mask is wrong (shifted, mirrored, of another view or object), or "
        "the pose of its image is. Use --image_list_path to select images, or "
        "--keep_all_views 1 to use all views",
        num_bad,
        judged.size(),
        num_grave,
        ListOf(summary.views)));
  }
  for (const BadView& view : summary.views) {
    WarnOf(view, context);
  }
  return summary;
}

}  // namespace octacut
