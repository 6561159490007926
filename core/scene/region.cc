#include "core/scene/region.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <string>

#include "core/base/check_option.h"
#include "core/base/error.h"
#include "core/scene/silhouette_box.h"
#include "core/scene/silhouette_pyramid.h"

namespace octacut {
namespace {

// The cube's edge is the longest side of the box times 1 + kCubeMargin, which
// keeps 2.4 voxels of 64^3 free on each side.
constexpr double kCubeMargin = 0.08;
// The coarse hull whose bounding box the region is has (2^level)^3 voxels.
constexpr int kHullLevel = 6;
constexpr size_t kMinPoints = 8;
// The margin in units of the longest side of the box of the sparse points,
// added on each side where the views do not bound the object: points seldom
// cover all of it.
constexpr double kPointMargin = 0.2;
// The share of views that have to show a sparse point of the object inside.
constexpr double kMinShareOfViews = 0.9;
// Of an object: floats hold the squares of its lengths, and their inverses.
constexpr double kLeastSize = 1e-15;
constexpr double kLargestSize = 1e15;

Region MakeRegion(const Eigen::AlignedBox3d& box, RegionSource source) {
  const double size = box.sizes().maxCoeff();
  if (!(size >= kLeastSize && size <= kLargestSize)) {
    throw InputError(fmt::format(
        "the object has a size of {:g} in the frame of the model: must be in "
        "[{:g}, {:g}]. Scale the model (colmap model_transformer)",
        size,
        kLeastSize,
        kLargestSize));
  }
  Region region;
  region.box = box;
  region.source = source;
  region.cube.edge = size * (1 + kCubeMargin);
  region.cube.min_corner =
      box.center() - Eigen::Vector3d::Constant(region.cube.edge / 2);
  return region;
}

// Box between the first and the last percentile of the points on each axis.
Eigen::AlignedBox3d RobustBox(const std::vector<Eigen::Vector3d>& points) {
  Eigen::AlignedBox3d box;
  const size_t skipped = points.size() / 100;
  std::vector<double> values(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (size_t i = 0; i < points.size(); ++i) {
      values[i] = points[i][axis];
    }
    std::sort(values.begin(), values.end());
    box.min()[axis] = values[skipped];
    box.max()[axis] = values[values.size() - 1 - skipped];
  }
  return box;
}

// The box of the points within the masks; empty when they are too few.
Eigen::AlignedBox3d PointBox(const std::vector<View>& views,
                             const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> inside;
  for (size_t i : PointsInsideMasks(views, points, kMinShareOfViews)) {
    inside.push_back(points[i]);
  }
  if (inside.size() < kMinPoints) {
    return {};
  }
  return RobustBox(inside);
}

// The region of silhouettes that may be too small. Its cube is that of the
// silhouettes as they are, so that the tolerance moves no voxel.
Region MakeTolerantRegion(const std::vector<View>& views,
                          const Eigen::AlignedBox3d& box,
                          double mask_tolerance) {
  double slack = 0;
  for (const View& view : views) {
    const double depth = (view.cam_from_world * box.center()).z();
    slack =
        std::max(slack, mask_tolerance * view.scale * depth / view.camera.fx);
  }
  Region region = MakeRegion(box, RegionSource::kSilhouettes);
  // Half of the cube's margin is left, so that a surface can close in it.
  const Eigen::Vector3d most = Eigen::Vector3d::Constant(
      region.cube.edge / 2 * (1 + kCubeMargin / 2) / (1 + kCubeMargin));
  const Eigen::AlignedBox3d cube(box.center() - most, box.center() + most);
  const Eigen::Vector3d grown = Eigen::Vector3d::Constant(slack);
  region.box = cube.intersection(
      Eigen::AlignedBox3d(box.min() - grown, box.max() + grown));
  return region;
}

// The region where the silhouettes do not settle it: from the sparse points,
// or, without enough of them, from what the silhouettes give all the same.
Region FallBack(const std::vector<View>& views,
                const std::vector<Eigen::Vector3d>& points,
                const SilhouetteBox& hull,
                double mask_tolerance,
                const Context& context) {
  const Eigen::AlignedBox3d point_box = PointBox(views, points);
  if (point_box.isEmpty()) {
    if (hull.box.isEmpty()) {
      throw InputError(fmt::format(
          "the bounding box of the object cannot be estimated: the "
          "views do not bound the object ({}), and there are too "
          "few sparse points inside the masks. Set `bounding_box` to "
          "x0,y0,z0,x1,y1,z1",
          hull.doubt));
    }
    context.Warn(fmt::format(
        "The estimated bounding box may be far too large: the views hardly "
        "bound the object ({}), and there are no sparse points inside the "
        "masks. Set `bounding_box` to x0,y0,z0,x1,y1,z1.",
        hull.doubt));
    return MakeTolerantRegion(views, hull.box, mask_tolerance);
  }
  const Eigen::Vector3d margin =
      Eigen::Vector3d::Constant(kPointMargin * point_box.sizes().maxCoeff());
  const Eigen::AlignedBox3d box(point_box.min() - margin,
                                point_box.max() + margin);
  if (!hull.box.isEmpty() && box.contains(hull.box)) {
    return MakeTolerantRegion(views, hull.box, mask_tolerance);
  }
  context.Warn(fmt::format(
      "The views do not bound the object ({}), so its bounding box is "
      "estimated from the sparse points inside the masks. Set `bounding_box` "
      "to "
      "x0,y0,z0,x1,y1,z1 to choose another one.",
      hull.doubt));
  const Eigen::AlignedBox3d carved =
      ShrinkToHull(views, true, box, kHullLevel, context);
  return MakeRegion(carved.isEmpty() ? box : carved,
                    RegionSource::kSparsePoints);
}

}  // namespace

std::string_view ToString(RegionSource source) {
  switch (source) {
    case RegionSource::kSilhouettes:
      return "silhouettes";
    case RegionSource::kSparsePoints:
      return "sparse points";
    case RegionSource::kGiven:
      return "given";
  }
  return "unknown";
}

void RegionOptions::Check() const {
  if (bounding_box) {
    const auto& box = *bounding_box;
    const bool finite = box.min().allFinite() && box.max().allFinite();
    const std::string numbers = fmt::format("{},{},{},{},{},{}",
                                            box.min().x(),
                                            box.min().y(),
                                            box.min().z(),
                                            box.max().x(),
                                            box.max().y(),
                                            box.max().z());
    CheckOption(finite && (box.min().array() < box.max().array()).all(),
                "bounding_box",
                numbers,
                "must be x0,y0,z0,x1,y1,z1, finite and with min < max");
    CheckOption(box.sizes().minCoeff() >= kLeastSize &&
                    box.sizes().maxCoeff() <= kLargestSize,
                "bounding_box",
                numbers,
                fmt::format("the sides of the box must be in [{:g}, {:g}]",
                            kLeastSize,
                            kLargestSize));
  }
  CheckOption(mask_tolerance >= 0 && mask_tolerance <= kMaxMaskTolerance,
              "mask_tolerance",
              mask_tolerance,
              fmt::format("must be in 0 .. {}", kMaxMaskTolerance));
}

Eigen::AlignedBox3d BoundingBoxFromNumbers(const std::vector<double>& numbers) {
  CheckOption(numbers.size() == 6,
              "bounding_box",
              fmt::format("{}", fmt::join(numbers, ",")),
              "must be six numbers x0,y0,z0,x1,y1,z1");
  RegionOptions options;
  options.bounding_box.emplace(
      Eigen::Vector3d(numbers[0], numbers[1], numbers[2]),
      Eigen::Vector3d(numbers[3], numbers[4], numbers[5]));
  options.Check();
  return *options.bounding_box;
}

std::optional<Eigen::AlignedBox3d> OptionalBoundingBox(
    const std::vector<double>& numbers) {
  if (numbers.empty()) {
    return {};
  }
  return BoundingBoxFromNumbers(numbers);
}

Region EstimateRegion(const std::vector<View>& views,
                      const std::vector<Eigen::Vector3d>& points,
                      const RegionOptions& options,
                      const Context& context) {
  options.Check();
  if (options.bounding_box) {
    return MakeRegion(*options.bounding_box, RegionSource::kGiven);
  }
  if (views.empty()) {
    throw InputError("the region cannot be estimated without views");
  }
  const SilhouetteBox hull = BoxOfSilhouettes(views, kHullLevel, context);
  return hull.sure
             ? MakeTolerantRegion(views, hull.box, options.mask_tolerance)
             : FallBack(views, points, hull, options.mask_tolerance, context);
}

void CheckFloatsResolve(const BoundingCube& cube, int level) {
  constexpr double kMaxShareOfVoxel = 0.05;
  const double farthest = cube.min_corner.cwiseAbs().maxCoeff() + cube.edge;
  const double spacing =
      farthest * double(std::numeric_limits<float>::epsilon());
  if (spacing > kMaxShareOfVoxel * cube.VoxelSize(level)) {
    throw InputError(fmt::format(
        "the object has a size of {:.3g} and coordinates up to {:.3g}: single "
        "precision is not sufficient for voxels of 2^-{} of that size at this "
        "distance from the origin. Move the model to the origin (colmap "
        "model_transformer) or choose a lower level",
        cube.edge,
        farthest,
        level));
  }
}

std::vector<size_t> PointsInsideMasks(
    const std::vector<View>& views,
    const std::vector<Eigen::Vector3d>& points,
    double min_share) {
  std::vector<size_t> inside(points.size());
  std::vector<size_t> outside(points.size());
  for (const View& view : views) {
    const SilhouettePyramid silhouette(view);
    for (size_t i = 0; i < points.size(); ++i) {
      const BoxVerdict verdict = silhouette.Classify(points[i]);
      inside[i] += verdict == BoxVerdict::kObject;
      outside[i] += verdict == BoxVerdict::kBackground;
    }
  }
  std::vector<size_t> result;
  for (size_t i = 0; i < points.size(); ++i) {
    if (inside[i] >= 2 &&
        double(inside[i]) >= min_share * double(inside[i] + outside[i])) {
      result.push_back(i);
    }
  }
  return result;
}

}  // namespace octacut
