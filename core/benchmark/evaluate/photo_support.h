// How far the photographs support a mesh, view by view and place by place.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/evaluate/reprojection.h"
#include "core/scene/scene.h"

namespace octacut {

struct ViewSupport {
  // Pixels of the object, by the mask, in the middle of a window of the
  // photograph that is not plain. They do not depend on the mesh.
  size_t textured_pixels = 0;
  // Those of them at which the mesh let neighbours be compared.
  size_t compared_pixels = 0;
  // Mean correlation over the textured pixels, where those that are not
  // compared count as 0: a mesh gains nothing by leaving parts out.
  double support = 0;
};

// `maps` are those of Reprojection. Throws InputError when a view has no image.
std::vector<ViewSupport> MeasureViewSupport(const std::vector<View>& views,
                                            const std::vector<cv::Mat>& maps,
                                            const Context& context);

// Over the views, each with the same weight; those without textured pixels do
// not count. 0 where none does.
double MeanSupport(const std::vector<ViewSupport>& support);

// Whether a view's support lies more than three robust standard deviations (of
// the median absolute deviation) and more than 0.05 below the median of all
// views: smaller differences are usual between views of different light.
std::vector<bool> ContradictingViews(const std::vector<ViewSupport>& support);

// For each point of the mesh's surface the mean of `maps` over the views that
// see it, by `depths` of the mesh; not a number where no view has a value. The
// same values for any number of threads.
std::vector<float> SupportOfPoints(const std::vector<Eigen::Vector3d>& points,
                                   const std::vector<View>& views,
                                   const std::vector<cv::Mat>& depths,
                                   const std::vector<cv::Mat>& maps,
                                   const Context& context);

}  // namespace octacut
