// Which pixels show the plane that an object stands on.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/segment/search_region.h"

namespace octacut {

// Side of the windows that are compared, pixels.
inline constexpr int kStandWindow = 9;

// For each view, CV_32F of its size: 1 for pixels that show the plane for sure,
// -1 for those that show something in front of it, 0 where nothing is known.
//
// Other views are carried over by way of the plane. What they then have in
// common with the view, by normalized cross-correlation in small windows, is on
// the plane; where only they agree with each other, it is hidden in the view.
// Brightness and its slow changes, such as shadows, do not count. Plain parts
// of the plane say nothing. `images` are CV_8UC3, BGR, of the size of the
// cameras; views are compared with those of similar direction from `center`.
std::vector<cv::Mat> FindStandPixels(std::span<const cv::Mat> images,
                                     std::span<const Pose> poses,
                                     const Eigen::Hyperplane<double, 3>& plane,
                                     const Eigen::Vector3d& center,
                                     const Context& context);

// Whether the plane is a stand by its pixels: it goes on away from the middle
// of the views, and something is in front of it. Nothing is in front of a flat
// top of the object.
bool IsStand(std::span<const cv::Mat> stand,
             std::span<const Pose> poses,
             const SearchRegion& region);

}  // namespace octacut
