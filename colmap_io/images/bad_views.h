// What is done about views that contradict the others.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/context.h"
#include "core/scene/contradictions.h"

namespace octacut {

struct BadView {
  std::string name;  // of the photograph, as the model has it
  std::filesystem::path mask_file;
  ViewFit fit;
  bool is_left_out = true;
};

struct BadViewSummary {
  bool is_judged = false;  // false: not asked for, or the views do not tell
  std::vector<BadView> views;
  ViewFit largest_left;  // of the views that fit the others
  double seconds = 0;
};

// A view of which FindContradictions speaks by its number.
struct JudgedView {
  std::string name;
  std::filesystem::path mask_file;
};

// Names the contradicting views in warnings and says which are left out: all if
// they are at most a tenth of `judged`. Masks of the object and of something
// that touches it do little harm, since the others take that away; where there
// are many of them they are used, with a warning. Throws InputError that lists
// all when more than a tenth are seriously wrong.
BadViewSummary DecideOnBadViews(const Contradictions& contradictions,
                                const std::vector<JudgedView>& judged,
                                const Context& context);

}  // namespace octacut
