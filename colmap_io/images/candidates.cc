#include "colmap_io/images/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>

#include "colmap_io/images/mask_content.h"
#include "core/base/error.h"
#include "core/scene/bites.h"

namespace octacut {

size_t LeaveOutMasksWithoutOutline(bool skips,
                                   const Context& context,
                                   std::vector<Candidate>* candidates) {
  const auto has_outline = [](const Candidate& candidate) {
    return candidate.mask.content == MaskContent::kOutline;
  };
  const auto first =
      std::find_if_not(candidates->begin(), candidates->end(), has_outline);
  if (first == candidates->end()) {
    return 0;
  }
  const size_t num_masks = candidates->size();
  const auto num_outlines = size_t(
      std::count_if(candidates->begin(), candidates->end(), has_outline));
  const std::string message = fmt::format(
      "{}: the mask is all {}; {} of {} masks show no outline",
      first->files.mask_file.string(),
      first->mask.content == MaskContent::kAllObject ? "object" : "background",
      num_masks - num_outlines,
      num_masks);
  if (!skips) {
    throw InputError(message +
                     " (--skip_missing_masks 1 leaves out their images)");
  }
  context.Warn(message + "; their images are left out");
  std::erase_if(*candidates, std::not_fn(has_outline));
  return num_masks - num_outlines;
}

void WarnOfInvertedMasks(const std::vector<Candidate>& candidates,
                         const Context& context) {
  const auto suspects = std::count_if(
      candidates.begin(), candidates.end(), [](const Candidate& candidate) {
        return candidate.mask.object_all_around;
      });
  if (size_t(suspects) * 2 > candidates.size()) {
    context.Warn(
        fmt::format("In {} of {} masks, the whole image border is object. If "
                    "the masks are inverted, correct them: 0 means background.",
                    suspects,
                    candidates.size()));
  }
}

size_t FillBites(double mask_tolerance,
                 const Context& context,
                 std::vector<Candidate>* candidates) {
  std::vector<View> views;
  for (const Candidate& candidate : *candidates) {
    views.push_back(candidate.mask.view);
  }
  const std::vector<Bite> bites = FindBites(views, mask_tolerance, context);
  for (const Bite& bite : bites) {
    Candidate& candidate = (*candidates)[bite.view];
    candidate.bites.Add(candidate.mask.view.camera, bite.pixels);
    candidate.mask.view.mask.setTo(255, bite.pixels);
    context.Info(fmt::format(
        "{}: {} pixels of the mask's background are filled, since the other "
        "masks show a piece of the object there",
        candidate.files.mask_file.string(),
        bite.num_pixels));
  }
  return bites.size();
}

void WarnOfMasksElsewhere(const std::vector<Candidate>& candidates,
                          const std::vector<View>& views,
                          const Context& context) {
  size_t count = 0;
  const Candidate* first = nullptr;
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (ContentOfMask(views[i].mask >= kObjectThreshold) ==
        MaskContent::kAllBackground) {
      ++count;
      first = first == nullptr ? &candidates[i] : first;
    }
  }
  if (count > 0) {
    context.Warn(
        fmt::format("{}: the mask shows no object within the bounding box; "
                    "this holds for {} of {} masks.",
                    first->files.mask_file.string(),
                    count,
                    candidates.size()));
  }
}

}  // namespace octacut
