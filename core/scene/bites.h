// Bites out of masks: the object's tips and edges that single masks lack.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"

namespace octacut {

struct Bite {
  size_t view = 0;
  size_t num_pixels = 0;
  // CV_8UC1 of the mask's size, 255: the bite, and the object within three
  // pixels of it, so that no border is left where a finer mask is filled.
  cv::Mat pixels;
};

// Points that one or two masks deny and all others show prove nothing: the hull
// of the others is always fatter than the object. But the object in each view
// has to be somewhere. A pixel of it is unexplained when on all of its line of
// sight some mask denies it, by more than the size of a cell (two pixels or so)
// and one pixel. Right masks leave none. A bite leaves the pixels of what is
// missing unexplained in all views that see it free of the rest.
//
// Masks have bites, then, where they deny points that are unexplained in at
// least three other views and a quarter of all; what leaves most unexplained is
// settled first, and what that explains counts no more. Bites are more than
// twice `mask_tolerance` (pixels of the photographs) deep, and at most a
// twentieth of the object: larger ones are left as they are. One mask of at
// least four may have a bite at a point, two of eight and more. Only masks and
// cameras are read; masks of low resolution will do. Views that do not bound
// the object have no bites. The same for any number of threads.
std::vector<Bite> FindBites(const std::vector<View>& views,
                            double mask_tolerance,
                            const Context& context);

}  // namespace octacut
