// How well the photographs agree over a mesh: each view is compared with its
// neighbours' images, reprojected over the surface. Needs no ground truth.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"

namespace octacut {

// Fixed, so that all figures of docs/accuracy.md mean the same.
struct ReprojectionOptions {
  int num_neighbors = 4;
  // Between the directions of a view and its neighbour from the middle of the
  // object, degrees; of these the nearest are taken.
  double min_angle = 5;
  double max_angle = 45;
  static constexpr int kWindowRadius = 3;  // windows of (2 r + 1)^2 pixels
  // Standard deviation of a window's grey levels below which it is plain: its
  // correlation says nothing, and is left out.
  static constexpr double kMinContrast = 2;
  // Whether Reprojection::maps is wanted, which takes four bytes per pixel.
  bool keep_maps = false;

  void Check() const;  // throws OptionError
};

struct Reprojection {
  size_t num_pairs = 0;    // of a view and a neighbour
  size_t num_windows = 0;  // whole, seen by both views, and not plain
  // Zero-mean normalised cross-correlation over the windows, -1 .. 1: 1 where
  // all agree.
  double mean_correlation = 0;
  // The tenth percentile of the windows' correlations.
  double percentile_10 = 0;
  // The share of the whole windows seen by both views that is plain.
  double plain_fraction = 0;
  // The share of the mesh's pixels that are in the middle of a whole window
  // with at least one neighbour.
  double compared_fraction = 0;
  // One per view, of its size, CV_32FC1: the mean correlation of the window
  // around each pixel over the neighbours; not a number where there is none.
  std::vector<cv::Mat> maps;
};

// For each view the indices of its neighbours as seen from `middle`, nearest
// first.
std::vector<std::vector<size_t>> ReprojectionNeighbors(
    const std::vector<View>& views,
    const Eigen::Vector3d& middle,
    const ReprojectionOptions& options);

// depths[i]: of the mesh in view i (RenderDepth). What a neighbour sees is told
// by its depth, up to three of its pixels. `middle` of the object, in the
// views' frame. The same figures for any number of threads. Throws InputError
// when a view has no image.
Reprojection MeasureReprojection(const std::vector<View>& views,
                                 const std::vector<cv::Mat>& depths,
                                 const Eigen::Vector3d& middle,
                                 const ReprojectionOptions& options,
                                 const Context& context);

}  // namespace octacut
