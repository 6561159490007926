// Pixels of a turntable's views that can show nothing but the object.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/segment/search_region.h"

namespace octacut {

// For each view, CV_8UC1 of its size: 255 for pixels that turn and whose rays
// do not meet the plate. A point of `plane` is of the plate if most views show
// it, and at most a quarter of these see background there that stands still.
//
// `labels` (CV_8UC1 of the views' sizes) are kSurroundingsLabel for what stands
// still and kNoLabel for what turns.
std::vector<cv::Mat> FindPixelsAbovePlate(
    std::span<const cv::Mat> labels,
    std::span<const Pose> poses,
    const Eigen::Hyperplane<double, 3>& plane,
    const Context& context);

// Part of those pixels (`above`, as FindPixelsAbovePlate returns them) that
// other views contradict: two of them or more see still background at every
// point of the pixel's ray within `region`. If the region has a box, only
// pixels that can show it count. Silhouettes of one object have few such
// pixels; if parts of it were taken for background in some views, the other
// views show them against this.
double ContradictedPart(std::span<const cv::Mat> labels,
                        std::span<const cv::Mat> above,
                        std::span<const Pose> poses,
                        const Eigen::Hyperplane<double, 3>& plane,
                        const SearchRegion& region,
                        const Context& context);

}  // namespace octacut
