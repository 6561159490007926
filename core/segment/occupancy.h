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

// Log odds of a pixel as evidence are cut off here: what a single view says for
// sure. A point that this much speaks against is one view's word from being
// object.
inline constexpr float kOneViewsWord = 4;

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

  // Takes what hangs together for one thing, and what is not part of the thing
  // that is largest and nearest to `center` (both count, within `radius`) for
  // background, and so all that is farther from it than a few voxels. Of the
  // other things, `keeps_parts` keeps those that may be parts of it which are
  // severed by a gap: they have one voxel for a hundred of its own, or more.
  // False when nothing is object.
  bool KeepThingAt(const Eigen::Vector3d& center,
                   double radius,
                   bool keeps_parts);

  // Box around the voxels that are object; empty when there are none.
  Eigen::AlignedBox3d ObjectBox() const;

  // For each pixel of a view, what the other views say of the point on its ray
  // that most of them hold for object: above 0 for object. CV_32F of the view's
  // size; at least -3 * kOneViewsWord.
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

  // For each voxel the number of the thing that it belongs to, -1 where it is
  // no object.
  std::vector<int> LabelThings(int* num_things) const;

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
