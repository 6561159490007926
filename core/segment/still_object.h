// The part of an object on a turntable that looks the same from all sides, or
// nearly the same.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "core/segment/still_background.h"

namespace octacut {

struct StillObject {
  cv::Mat mask;  // CV_8UC1, 0 or 255
  // CV_8UC1: what of it is there in all photographs, and what is background in
  // all of them. Empty where nothing stands still.
  cv::Mat sure;
  cv::Mat sure_background;
  // Why it cannot be told from the background, as a part of a sentence; empty
  // when it can, or when there is none.
  std::string doubt;
};

// `turning` (CV_8UC1, not zero) is what never shows the background, such as the
// plate's pattern. What stands still, or varies more than the background
// (`varies`, as WhatVaries has it), between two such points of a row is in
// front of the plate, since what turns sweeps whole rows. From there on,
// colours that the background does not have beside and below what turns decide,
// and the border is where the photographs have one.
StillObject FindStillObject(const StillBackground& background,
                            const cv::Mat& varies,
                            const cv::Mat& turning);

}  // namespace octacut
