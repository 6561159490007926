// The background behind a turntable, from photographs of a camera that stands
// still.
#pragma once

#include <opencv2/core/mat.hpp>
#include <span>

#include "core/base/context.h"

namespace octacut {

// CIE Lab in 8 bits, as OpenCV has it: CV_8UC3.
cv::Mat ToLab(const cv::Mat& image);

struct StillBackground {
  // CV_32FC3, Lab in the units of 8 bits: what a point looks like most often.
  cv::Mat color;
  // CV_32F: part of the photographs that show this, as far as the window of
  // kStillWindow pixels around the point shows it too, and the same for windows
  // of WideWindow pixels. The pattern of a turning plate may bring back a pixel
  // or a small window, but hardly a wide one.
  cv::Mat support;
  cv::Mat wide_support;
  // Distance in Lab from which on two pixels differ by more than noise.
  float tolerance = 0;
};

// CV_32F: 1 where `lab` (CV_8UC3) differs from `color` (CV_32FC3) by less than
// the tolerance, 0 elsewhere.
cv::Mat LooksLike(const cv::Mat& lab, const cv::Mat& color, float tolerance);

inline constexpr int kStillWindow = 9;
// CV_32F: the means of windows of so many pixels around each one.
cv::Mat WindowMean(const cv::Mat& values, int window = kStillWindow);
// Part of a window that must look like something for the window to show it.
inline constexpr float kMostOfWindow = 0.85f;
// An odd number of pixels, a twenty-fifth of the longer side.
int WideWindow(const cv::Size& size);

// `labs` are of one size. The noise is that of the quarter of the pixels that
// change least: at least as many have to show what stands still.
StillBackground FindStillBackground(std::span<const cv::Mat> labs,
                                    const Context& context);

// CV_8U, 255 where the photographs that show the background differ by more than
// noise: a plain surface that turns in the light, and not the background.
cv::Mat WhatVaries(std::span<const cv::Mat> labs,
                   const StillBackground& background,
                   const Context& context);

// CV_32F: distance of each pixel of `lab` from the background in units of the
// tolerance. What would be nearer as the background in shadow, with 0.4 to all
// of its light, has a distance of at most one: it may be either.
cv::Mat DistanceFromBackground(const cv::Mat& lab,
                               const StillBackground& background);

}  // namespace octacut
