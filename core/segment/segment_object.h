// The object in all views at once, without anybody's clicks.
//
// The cameras look at the object: colours of the middle that the outside does
// not have are a first model of it. Then evidence in space (occupancy.h) and in
// each view (appearance.h) alternate, each made from the other, until the
// silhouettes settle. After N. Campbell, G. Vogiatzis, C. Hernandez and R.
// Cipolla, "Automatic 3D Object Segmentation in Multiple Views using Volumetric
// Graph-Cuts" (BMVC 2007, IVC 2010), and W. Lee, W. Woo and E. Boyer,
// "Silhouette Segmentation in Multiple Views" (PAMI 2011).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/segment/search_region.h"

namespace octacut {

// A view to be segmented.
struct UnsegmentedView {
  Pose pose;
  cv::Mat image;  // CV_8UC3, BGR, of the camera's size
  // CV_8UC1 of that size: 0 background, 255 object, 128 unknown; empty if all
  // is unknown.
  cv::Mat labels;
  // Whether `labels` are of a turntable: what they do not call background turns
  // with the object.
  bool is_turntable = false;
  // CV_8UC1 of that size, of a turntable whose plate is known: 255 where the
  // view can show nothing but the object. UseTurntable sets it.
  cv::Mat above_plate;
  // CV_8UC1 of that size, as labels: what may be the object, from elsewhere.
  // The first colours are learned from it; empty: from where the cameras look.
  cv::Mat proposal;
  // Pixels that show sparse points of the stand: their colours are learned.
  std::vector<Eigen::Vector2d> stand_points;
  // CV_32F of that size, as FindStandPixels has it: 1 for the stand, -1 for
  // something in front of it; empty when no stand is known.
  cv::Mat stand;
};

struct SegmentationInput {
  std::vector<UnsegmentedView> views;
  std::optional<Eigen::AlignedBox3d> box;  // around the object, if known
  // What the object stands on, if known: there is no object on its negative
  // side.
  std::optional<Eigen::Hyperplane<double, 3>> floor;
};

struct SegmentedView {
  // CV_32F of the view's size: log odds of object against background from
  // colours and from the other views.
  cv::Mat log_odds;
  // CV_32F: log odds from colours (of this view's model and of that of all
  // views) and from the stand, without the other silhouettes; within
  // +-kMaxViewLogOdds but where labels say more.
  cv::Mat colours;
  // Of the other views, as ConsensusOfOthers has it.
  cv::Mat others;
  // CV_8UC1 of that size, 0 or 255: the minimal cut by those log odds.
  cv::Mat mask;
};

struct Segmentation {
  std::vector<SegmentedView> views;
  SearchRegion region;
  Eigen::AlignedBox3d object_box;
};

// Throws InputError where the object cannot be found: see FindSearchRegion, or
// nothing in the middle looks different from the outside.
Segmentation SegmentObject(const SegmentationInput& input,
                           const Context& context);

}  // namespace octacut
