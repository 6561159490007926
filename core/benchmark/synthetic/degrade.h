// What is wrong with real photographs, masks and cameras, in known amounts.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "core/scene/camera.h"

namespace octacut {

struct DegradeOptions {
  // Standard deviation of each pixel's noise, in grey levels of 255.
  double pixel_noise = 0;
  // Standard deviation of each view's exposure, as a factor - 1.
  double exposure_noise = 0;
  // Pixels by which masks are too large (positive) or too small (negative).
  int mask_offset = 0;
  // Discs cut out of each mask's object, and discs of background that claim
  // to be object; their radius in pixels.
  int num_mask_holes = 0;
  int num_mask_specks = 0;
  double mask_defect_radius = 2;
  // Standard deviation, in pixels, by which a reported pose displaces the
  // object's centre in the image, in x and in y.
  double pose_noise = 0;

  void Check() const;  // throws OptionError
};

// `seed` differs from view to view.
void DegradeImage(const DegradeOptions& options,
                  uint64_t seed,
                  cv::Mat& image);  // CV_8UC3
void DegradeMask(const DegradeOptions& options,
                 uint64_t seed,
                 cv::Mat& mask);  // CV_8UC1

// Turns the camera about its own centre by as much as moves the image by
// pose_noise pixels at its middle (x and y) and about the viewing axis at its
// border.
Rigid3d DegradePose(const DegradeOptions& options,
                    uint64_t seed,
                    const PinholeCamera& camera,
                    const Rigid3d& cam_from_world);

}  // namespace octacut
