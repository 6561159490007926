// The images of a model on their way to the views of a scene, and what their
// reduced masks tell.
#pragma once

#include <cstddef>
#include <vector>

#include "colmap_io/images/filled_bites.h"
#include "colmap_io/images/mask_view.h"
#include "colmap_io/images/view_files.h"
#include "core/base/context.h"
#include "core/scene/scene.h"

namespace octacut {

struct Candidate {
  ViewFiles files;
  MaskView mask;
  FilledBites bites;
};

// Removes those whose mask is all object or all background, with a warning, and
// returns their number. Throws InputError instead unless `skips`.
size_t LeaveOutMasksWithoutOutline(bool skips,
                                   const Context& context,
                                   std::vector<Candidate>* candidates);

// Where most masks are object all around.
void WarnOfInvertedMasks(const std::vector<Candidate>& candidates,
                         const Context& context);

// Fills what FindBites finds, and returns the number of bites.
size_t FillBites(double mask_tolerance,
                 const Context& context,
                 std::vector<Candidate>* candidates);

// `views` are those of the candidates. A bounding box of the user's takes the
// place of the search for the region, which would have named a mask that does
// not fit the others.
void WarnOfMasksElsewhere(const std::vector<Candidate>& candidates,
                          const std::vector<View>& views,
                          const Context& context);

}  // namespace octacut
