#include "core/benchmark/synthetic/degrade.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/check_option.h"
#include "core/benchmark/synthetic/move_mask_border.h"
#include "core/benchmark/synthetic/noise.h"
#include "core/scene/scene.h"

namespace octacut {

void DegradeOptions::Check() const {
  CheckOption(pixel_noise >= 0,
              "degrade.pixel_noise",
              pixel_noise,
              "must not be negative");
  CheckOption(exposure_noise >= 0 && exposure_noise <= 0.3,
              "degrade.exposure_noise",
              exposure_noise,
              "must be in [0, 0.3]");
  CheckOption(std::abs(mask_offset) <= 100,
              "degrade.mask_offset",
              mask_offset,
              "must be in [-100, 100]");
  CheckOption(num_mask_holes >= 0 && num_mask_holes <= 1000,
              "degrade.num_mask_holes",
              num_mask_holes,
              "must be in 0 .. 1000");
  CheckOption(num_mask_specks >= 0 && num_mask_specks <= 1000,
              "degrade.num_mask_specks",
              num_mask_specks,
              "must be in 0 .. 1000");
  CheckOption(mask_defect_radius > 0 && mask_defect_radius <= 1000,
              "degrade.mask_defect_radius",
              mask_defect_radius,
              "must be positive and at most 1000");
  CheckOption(pose_noise >= 0 && pose_noise <= 1000,
              "degrade.pose_noise",
              pose_noise,
              "must be in 0 .. 1000");
}

void DegradeImage(const DegradeOptions& options,
                  uint64_t seed,
                  cv::Mat& image) {
  if (options.pixel_noise == 0 && options.exposure_noise == 0) {
    return;
  }
  const double exposure =
      std::max(0.1, 1 + options.exposure_noise * HashNormal(HashBits(seed, 9)));
  for (int y = 0; y < image.rows; ++y) {
    auto* pixels = image.ptr<cv::Vec3b>(y);
    for (int x = 0; x < image.cols; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        const double noise =
            options.pixel_noise == 0
                ? 0
                : options.pixel_noise *
                      HashNormal(HashBits(seed, y, x, channel));
        pixels[x][channel] =
            cv::saturate_cast<uint8_t>(exposure * pixels[x][channel] + noise);
      }
    }
  }
}

namespace {

// Draws discs of `value` around random pixels that are object (or
// background).
void AddDefects(int count,
                double radius,
                bool on_object,
                uint8_t value,
                uint64_t seed,
                cv::Mat& mask) {
  if (count == 0) {
    return;
  }
  std::vector<cv::Point> candidates;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if ((mask.at<uint8_t>(y, x) >= kObjectThreshold) == on_object) {
        candidates.emplace_back(x, y);
      }
    }
  }
  if (candidates.empty()) {
    return;
  }
  for (int i = 0; i < count; ++i) {
    const cv::Point center = candidates[HashBits(seed, i) % candidates.size()];
    const int reach = static_cast<int>(std::ceil(radius));
    for (int y = std::max(0, center.y - reach);
         y <= std::min(mask.rows - 1, center.y + reach);
         ++y) {
      for (int x = std::max(0, center.x - reach);
           x <= std::min(mask.cols - 1, center.x + reach);
           ++x) {
        if (std::hypot(x - center.x, y - center.y) < radius) {
          mask.at<uint8_t>(y, x) = value;
        }
      }
    }
  }
}

}  // namespace

void DegradeMask(const DegradeOptions& options, uint64_t seed, cv::Mat& mask) {
  mask = MoveMaskBorder(mask, options.mask_offset);
  AddDefects(options.num_mask_holes,
             options.mask_defect_radius,
             true,
             0,
             HashBits(seed, 21),
             mask);
  AddDefects(options.num_mask_specks,
             options.mask_defect_radius,
             false,
             255,
             HashBits(seed, 22),
             mask);
}

Rigid3d DegradePose(const DegradeOptions& options,
                    uint64_t seed,
                    const PinholeCamera& camera,
                    const Rigid3d& cam_from_world) {
  if (options.pose_noise == 0) {
    return cam_from_world;
  }
  const double border = std::max(camera.width, camera.height) / 2.0;
  const Eigen::Vector3d angles =
      options.pose_noise *
      Eigen::Vector3d(HashNormal(HashBits(seed, 31)) / camera.fy,
                      HashNormal(HashBits(seed, 32)) / camera.fx,
                      HashNormal(HashBits(seed, 33)) / border);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angles.norm(), angles.normalized()).toRotationMatrix();
  return {turn * cam_from_world.rotation, turn * cam_from_world.translation};
}

}  // namespace octacut
