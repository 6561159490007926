// How well a mesh fills the silhouettes it was made from: a measure that
// needs no ground truth.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <utility>
#include <vector>

#include "core/base/context.h"
#include "core/raycast/ray_scene.h"
#include "core/scene/scene.h"

namespace octacut {

// One view. A pixel is object, and covered by the mesh, from a coverage of a
// half on.
struct ViewSilhouette {
  size_t object_pixels = 0;  // of the mask
  size_t mesh_pixels = 0;
  size_t common_pixels = 0;
  // Between the two outlines, both ways, pixels; the view's diagonal where
  // only one of them exists. Weighted by length.
  double outline_mean = 0;
  double outline_max = 0;
};

struct SilhouetteAgreement {
  std::vector<ViewSilhouette> views;
  // Over all pixels of all views.
  double intersection_over_union = 0;
  // Pixels of the object that the mesh does not cover, and of the background
  // that it covers: both as fractions of the object's pixels, so that the size
  // of the frame does not matter.
  double missed = 0;
  double excess = 0;
  // Distances between all outlines, pixels.
  double outline_mean = 0;
  double outline_percentile_95 = 0;
};

// Distances along one view's outlines, with the length that each stands for.
using OutlineDistances = std::vector<std::pair<double, double>>;

// The distance that the given fraction of the length keeps to; 0 of nothing.
double OutlinePercentile(OutlineDistances distances, double fraction);

// Coverages of the same size, CV_8UC1. Appends to `distances`.
ViewSilhouette CompareSilhouettes(const cv::Mat& mask,
                                  const cv::Mat& mesh_coverage,
                                  OutlineDistances* distances);

// `rays` is of the mesh, in the frame of the views; depths[i] is its depth in
// view i (RenderDepth). Pixels that no photograph covers count as object, as
// in the masks. The same figures for any number of threads. Throws InputError
// when there are no views, or no object in any mask.
SilhouetteAgreement MeasureSilhouettes(const RayScene& rays,
                                       const std::vector<View>& views,
                                       const std::vector<cv::Mat>& depths,
                                       const Context& context);

}  // namespace octacut
