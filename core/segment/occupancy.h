// Which points views together hold for object: evidence of pixels, gathered in
// voxels.
//
// Follows J.-S. Franco and E. Boyer, "Fusion of Multi-View Silhouette Cues
// Using a Space Occupancy Grid" (ICCV 2005): a pixel of background is evidence
// against every point on its ray, a pixel of object hardly any for one of them,
// since another one may cause it.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"
#include "core/segment/search_region.h"

namespace octacut {

// The log odds of a pixel are limited to +- this before they become evidence,
// so that a single view counts no more than that.
inline constexpr float kMaxViewLogOdds = 4;

class OccupancyGrid {
 public:
  // `log_odds` holds for each view, CV_32F of its size, the logarithm of how
  // much likelier the pixel is as object than as background; 0 where nothing is
  // known. `resolution` voxels lie along an edge of the cube.
  OccupancyGrid(const BoundingCube& cube,
                int resolution,
                const SearchBounds& bounds,
                std::span<const Pose> poses,
                std::span<const cv::Mat> log_odds,
                const Context& context);

  // Keeps the connected component of object voxels with the largest weight: the
  // sum over its voxels of a Gaussian of `radius` around `center`. With
  // `keeps_parts`, also those of at least a hundredth of its size, which may be
  // parts of it severed by a gap. Voxels more than a few voxels away from what
  // is kept become background. Returns false if no voxel is object.
  bool KeepMainComponent(const Eigen::Vector3d& center,
                         double radius,
                         bool keeps_parts);

  // Box around the voxels that are object; empty when there are none.
  Eigen::AlignedBox3d ObjectBox() const;

  // For each pixel of a view, what the other views say of the point on its ray
  // that most of them hold for object: above 0 for object. CV_32F of the view's
  // size; at least -3 * kMaxViewLogOdds.
  cv::Mat LogOddsOfOthers(size_t view) const;
  // The same where that many other views are all sure of the object.
  static float LogOddsOfSure(size_t num_others);

 private:
  struct EvidenceView {
    Pose pose;         // at the resolution of `evidence`
    cv::Mat evidence;  // CV_32F; a pixel is about as wide as a voxel
  };

  size_t IndexOf(int x, int y, int z) const {
    return (size_t(z) * size_t(resolution_) + size_t(y)) * size_t(resolution_) +
           size_t(x);
  }
  class PointProjector;

  // For each voxel the number of its connected component, -1 where it is no
  // object.
  std::vector<int> LabelComponents(int* num_components) const;

  // Sets the flags (one per voxel) of a few voxels around each that is set.
  void Grow(std::vector<uint8_t>* flags) const;
  Eigen::Vector3d CenterOf(int x, int y, int z) const;
  // The same from the cube's least corner.
  Eigen::Vector3d OffsetOf(int x, int y, int z) const;
  float ScoreOf(const Eigen::Vector3f& offset,
                std::span<const PointProjector> projectors,
                bool is_allowed) const;
  void AddSlice(int z, const SearchBounds& bounds);

  BoundingCube cube_;
  int resolution_;
  std::vector<EvidenceView> views_;
  std::vector<cv::Size> sizes_;
  std::vector<float> scores_;  // one per voxel: object above 0
};

}  // namespace octacut
