// The silhouette of one view as a summed-area table and as the pyramid over its
// bounds: what a box in space may be, judged by this view alone. Conservative:
// no box that holds part of the object is called background.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "core/scene/scene.h"

namespace octacut {

enum class BoxVerdict : uint8_t {
  kBackground,  // no point of the box is object
  kMixed,       // a part of the box may tell more
  kObject,      // every point of the box projects onto the object
  kUnknown,     // the box is out of this view's sight: no part tells more
};

class SilhouettePyramid {
 public:
  // Keeps neither image nor mask. With `trust_sides` a view whose silhouette
  // touches some sides of its frame still bounds the object at the others.
  explicit SilhouettePyramid(const View& view, bool trust_sides = false);

  // The silhouette touches no side of its frame. Since the object is one
  // piece, all of it is inside the frame, and what projects outside is
  // background; other views say nothing about the outside of their frame. The
  // frame is the photograph's here. Silhouette, in core/views, never tells what
  // is outside: its frame is a crop, clear of the object only as far as the
  // region is right.
  bool IsClosed() const { return closed_; }
  bool HasObject() const { return max_x_ > min_x_; }

  // An axis-aligned box in world coordinates.
  BoxVerdict Classify(const Eigen::AlignedBox3d& box) const;
  // The same for one point; kObject or kBackground or, out of sight of an open
  // view, kUnknown.
  BoxVerdict Classify(const Eigen::Vector3d& point) const;

 private:
  struct Plane {  // in world coordinates; object only where value >= 0
    Eigen::Vector3d normal;
    double offset;
  };
  void BuildTable(const cv::Mat& mask);
  void BuildPlanes(bool trust_sides);
  BoxVerdict ClassifyRectangle(double x0,
                               double y0,
                               double x1,
                               double y1) const;
  int64_t Count(int x0, int y0, int x1, int y1) const;

  PinholeCamera camera_;
  Rigid3d cam_from_world_;
  bool closed_ = false;
  // Object pixels are within [min, max) of the frame.
  int min_x_ = 0, min_y_ = 0, max_x_ = 0, max_y_ = 0;
  std::vector<Plane> planes_;
  std::vector<uint32_t> table_;  // (height + 1) x (width + 1)
};

}  // namespace octacut
