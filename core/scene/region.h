// The region of space that holds the object: the box to reconstruct in and the
// bounding cube V^0 around it, from the intersection of the views' silhouette
// pyramids.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"

namespace octacut {

enum class RegionSource {
  kSilhouettes,   // the intersection of the silhouette pyramids
  kSparsePoints,  // the views do not bound it
  kGiven,         // RegionOptions::bounding_box
};
std::string_view ToString(RegionSource source);

struct Region {
  BoundingCube cube;        // centred at `box`, and somewhat larger
  Eigen::AlignedBox3d box;  // world coordinates
  RegionSource source = RegionSource::kSilhouettes;
};

struct RegionOptions {
  // Used as it is when set.
  std::optional<Eigen::AlignedBox3d> bounding_box;
  // Pixels of the photographs by which masks may be too small: the box, not
  // the cube, grows by as much.
  double mask_tolerance = 0;

  void Check() const;
};

// The box of `x0,y0,z0,x1,y1,z1`. Throws OptionError unless there are six
// finite numbers with min < max.
Eigen::AlignedBox3d BoundingBoxFromNumbers(const std::vector<double>& numbers);

// The same; none of no numbers.
std::optional<Eigen::AlignedBox3d> OptionalBoundingBox(
    const std::vector<double>& numbers);

// Region of the one object whose silhouettes are the masks of `views` (images
// are not needed; masks of low resolution do as long as a pixel is object when
// any part of it may be). Conservative: nothing that all views could show as
// object is cut off, except pieces of the silhouettes' intersection that hang
// together with nothing and are small (phantoms: the object is one piece).
//
// A view in which the silhouette touches the frame says nothing about what is
// outside its frame. Where the views leave the region unbounded, it is the
// robust box of those `points` that are inside the masks, and context.Warn
// says so. Throws InputError when there are too few of them, or when no point
// in space is object in all views.
Region EstimateRegion(const std::vector<View>& views,
                      const std::vector<Eigen::Vector3d>& points,
                      const RegionOptions& options,
                      const Context& context);

// Meshes are kept in floats, as files have them. Throws InputError where the
// object is so far from the origin that those are coarser than a twentieth of a
// voxel of `level`.
void CheckFloatsResolve(const BoundingCube& cube, int level);

// Numbers of those `points` (ascending) that at least two views show inside
// their silhouette, and that are inside in at least `min_share` of the views.
// Views that have the point out of sight do not count, unless the object is
// clear of their frame: the point is outside then.
std::vector<size_t> PointsInsideMasks(
    const std::vector<View>& views,
    const std::vector<Eigen::Vector3d>& points,
    double min_share);

}  // namespace octacut
