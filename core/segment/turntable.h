// What turns in front of a camera that stands still: silhouettes before there
// are any camera poses.
//
// On a turntable the still background has more features than the object, and
// structure from motion finds that nothing moves. What stays the same in all
// photographs is background. Two things need more: what always covers its point
// (the plate, the body of the object) never shows the background there, and an
// object that looks the same from all sides stays the same as well.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/base/context.h"

namespace octacut {

struct TurntableInput {
  // CV_8UC3, BGR, at least three, of one size and from one camera, in the order
  // in which the object turned, once around.
  std::vector<cv::Mat> images;
  // The same set without the object, with the plate or without; may be empty.
  std::vector<cv::Mat> empty_set;
};

struct TurntableView {
  // CV_8UC1, 0 or 255: the object, and the plate as far as it can be seen to
  // turn.
  cv::Mat mask;
  // Part of the border where object and background differ on both sides.
  double confidence = 0;
  // Why the view is not trusted, as a part of a sentence; empty when it is.
  std::string doubt;
};

// Throws InputError when nothing turns, or when the background does not stand
// still.
std::vector<TurntableView> SegmentTurntable(const TurntableInput& input,
                                            const Context& context);

}  // namespace octacut
