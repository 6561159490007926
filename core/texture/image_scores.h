// How like a photograph a picture is: PSNR and SSIM.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>

namespace octacut {

// Sums over any number of pairs of images.
struct ImageScores {
  size_t num_pixels = 0;
  double squared_error = 0;  // sum over pixels of the mean of the channels
  size_t num_windows = 0;
  double ssim_sum = 0;

  // Decibels, of all pixels together; infinite for equal images.
  double Psnr() const;
  double Ssim() const;
};

// Adds the pixels of `picture` and `photograph` (CV_8UC3) at which `region`
// (CV_8UC1) is not 0. The structural similarity (Z. Wang et al., "Image Quality
// Assessment", TIP 2004; Gaussian windows of 11 pixels, of grey values) counts
// where its whole window is in the region.
void AddScores(const cv::Mat& picture,
               const cv::Mat& photograph,
               const cv::Mat& region,
               ImageScores* scores);

// The score that a picture with all of the detail and none of the noise would
// have: adds the noise of the pixels whose neighbours are in the region, too,
// as differences of second order show it (J. Immerkaer, "Fast Noise Variance
// Estimation", CVIU 1996, with squares). Detail of a pixel's size counts as
// noise; noise that JPEG has smoothed is missed in part. Has no SSIM.
void AddNoise(const cv::Mat& photograph,
              const cv::Mat& region,
              ImageScores* scores);

}  // namespace octacut
