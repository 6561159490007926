#include "core/scene/region.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check_option.h"
#include "core/base/error.h"
#include "core/scene/coarse_hull.h"
#include "core/scene/silhouette_pyramid.h"

namespace octacut {
namespace {

// The search begins with a box this many times as large as the cameras are
// spread; what is farther away than that has no parallax.
constexpr double kSearchExtent = 100;
constexpr int kMaxIterations = 40;
// Refining ends when no side of the box shrinks by more.
constexpr double kConverged = 0.01;
constexpr double kPhantomFraction = 0.02;
constexpr size_t kMinPoints = 8;
// Length of the mean viewing direction above which all cameras are on one
// side: that of directions spread over a cone of 45 degrees about its axis.
constexpr double kOneSided = 0.85;

std::vector<SilhouettePyramid> MakeSilhouettes(const std::vector<View>& views,
                                               bool trust_sides) {
  std::vector<SilhouettePyramid> silhouettes;
  silhouettes.reserve(views.size());
  for (const View& view : views) {
    silhouettes.emplace_back(view, trust_sides);
  }
  return silhouettes;
}

Region MakeRegion(const Eigen::AlignedBox3d& box,
                  RegionSource source,
                  const RegionOptions& options) {
  Region region;
  region.box = box;
  region.source = source;
  region.cube.edge = box.sizes().maxCoeff() * (1 + options.margin);
  region.cube.min_corner =
      box.center() - Eigen::Vector3d::Constant(region.cube.edge / 2);
  return region;
}

// Shrinks the box to the hull inside it until nothing changes.
Eigen::AlignedBox3d ShrinkToHull(
    const std::vector<SilhouettePyramid>& silhouettes,
    Eigen::AlignedBox3d box,
    int level,
    const Context& context) {
  // Pieces are told apart only once cells are small against the object.
  double min_fraction = 0;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const CoarseHull hull = CarveBox(silhouettes, box, level, context);
    const Eigen::AlignedBox3d next = BoundingBoxOfPieces(hull, min_fraction);
    if (next.isEmpty()) {
      return next;
    }
    const bool converged =
        (next.sizes().array() >= (1 - kConverged) * box.sizes().array()).all();
    box = next;
    if (converged && min_fraction > 0) {
      break;
    }
    if (converged) {
      min_fraction = kPhantomFraction;
    }
  }
  return box;
}

Eigen::AlignedBox3d SearchBox(const std::vector<View>& views) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const View& view : views) {
    mean += view.Center() / double(views.size());
  }
  double spread = 0;
  for (const View& view : views) {
    spread = std::max(spread, (view.Center() - mean).norm());
  }
  const Eigen::Vector3d half =
      Eigen::Vector3d::Constant(kSearchExtent * spread);
  return {mean - half, mean + half};
}

bool AllOnOneSide(const std::vector<View>& views,
                  const Eigen::Vector3d& center) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const View& view : views) {
    sum += (view.Center() - center).normalized();
  }
  return sum.norm() > kOneSided * double(views.size());
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
  for (size_t i : PointsInsideMasks(views, points)) {
    inside.push_back(points[i]);
  }
  if (inside.size() < kMinPoints) {
    return {};
  }
  return RobustBox(inside);
}

struct SilhouetteBox {
  Eigen::AlignedBox3d box;  // empty when the silhouettes leave it unbounded
  // Nothing is wrong with it; otherwise `doubt` says what is.
  bool sure = false;
  std::string_view doubt;
};

// The region of silhouettes that may be too small. Its cube is that of the
// silhouettes as they are, so that the tolerance moves no voxel.
Region MakeTolerantRegion(const std::vector<View>& views,
                          const Eigen::AlignedBox3d& box,
                          const RegionOptions& options) {
  double slack = 0;
  for (const View& view : views) {
    const double depth = (view.cam_from_world * box.center()).z();
    slack = std::max(
        slack, options.mask_tolerance * view.scale * depth / view.camera.fx);
  }
  Region region = MakeRegion(box, RegionSource::kSilhouettes, options);
  const Eigen::Vector3d most = Eigen::Vector3d::Constant(region.cube.edge / 2);
  const Eigen::AlignedBox3d cube(box.center() - most, box.center() + most);
  const Eigen::Vector3d grown = Eigen::Vector3d::Constant(slack);
  region.box = cube.intersection(
      Eigen::AlignedBox3d(box.min() - grown, box.max() + grown));
  return region;
}

// Names the one mask without which the others have points in common, if there
// is just one: among hundreds it is hard to find by eye.
[[noreturn]] void RefuseMasks(const std::vector<View>& views,
                              const Eigen::AlignedBox3d& search,
                              const RegionOptions& options,
                              const Context& context) {
  std::vector<SilhouettePyramid> silhouettes = MakeSilhouettes(views, false);
  std::vector<size_t> culprits;
  for (size_t i = 0; i < views.size() && culprits.size() < 2; ++i) {
    context.ThrowIfCancelled();
    std::swap(silhouettes[i], silhouettes.back());
    const SilhouettePyramid left_out = std::move(silhouettes.back());
    silhouettes.pop_back();
    if (!ShrinkToHull(silhouettes, search, options.hull_level, context)
             .isEmpty()) {
      culprits.push_back(i);
    }
    silhouettes.push_back(left_out);
    std::swap(silhouettes[i], silhouettes.back());
  }
  throw InputError(fmt::format(
      "no point in space is object in all {} masks: the masks do not fit the "
      "camera poses ({})",
      views.size(),
      culprits.size() == 1
          ? fmt::format(
                "but for that of {}, which is wrong or has a wrong pose",
                views[culprits.front()].name)
          : "wrong or inverted masks, or another geometry"));
}

// What the silhouettes alone say.
SilhouetteBox BoxOfSilhouettes(const std::vector<View>& views,
                               const RegionOptions& options,
                               const Context& context) {
  const Eigen::AlignedBox3d search = SearchBox(views);
  if (!(search.sizes().x() > 0)) {
    return {{}, false, "all cameras are at one place"};
  }
  const Eigen::Vector3d slack =
      Eigen::Vector3d::Constant(1e-6 * search.sizes().x());
  const Eigen::AlignedBox3d interior(search.min() + slack,
                                     search.max() - slack);
  // Views that cut the object off bound it only if the others do not: their
  // untouched sides need the object not to turn back outside of the frame.
  for (const bool trust_sides : {false, true}) {
    const Eigen::AlignedBox3d box =
        ShrinkToHull(MakeSilhouettes(views, trust_sides),
                     search,
                     options.hull_level,
                     context);
    if (box.isEmpty()) {
      RefuseMasks(views, search, options, context);
    }
    if (interior.contains(box)) {
      if (AllOnOneSide(views, box.center())) {
        return {box, false, "all cameras are on one side of it"};
      }
      return {box, !trust_sides, "it leaves the frame in too many views"};
    }
  }
  return {{}, false, "it leaves the frame or the views are too much alike"};
}

// The region where the silhouettes do not settle it: from the sparse points,
// or, without enough of them, from what the silhouettes give all the same.
Region FallBack(const std::vector<View>& views,
                const std::vector<Eigen::Vector3d>& points,
                const SilhouetteBox& hull,
                const RegionOptions& options,
                const Context& context) {
  const Eigen::AlignedBox3d point_box = PointBox(views, points);
  if (point_box.isEmpty()) {
    if (hull.box.isEmpty()) {
      throw InputError(fmt::format(
          "the views do not bound the object ({}) and there are too few sparse "
          "points inside the masks: pass "
          "--OctahedralMeshing.bounding_box x0,y0,z0,x1,y1,z1",
          hull.doubt));
    }
    context.Warn(fmt::format(
        "the views hardly bound the object ({}) and there are no sparse points "
        "on it: the region may be far too large; "
        "--OctahedralMeshing.bounding_box x0,y0,z0,x1,y1,z1 sets it",
        hull.doubt));
    return MakeTolerantRegion(views, hull.box, options);
  }
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(
      options.point_margin * point_box.sizes().maxCoeff());
  const Eigen::AlignedBox3d box(point_box.min() - margin,
                                point_box.max() + margin);
  if (!hull.box.isEmpty() && box.contains(hull.box)) {
    return MakeTolerantRegion(views, hull.box, options);
  }
  context.Warn(fmt::format(
      "the views do not bound the object ({}): the region comes from the "
      "sparse points inside the masks; "
      "--OctahedralMeshing.bounding_box x0,y0,z0,x1,y1,z1 overrides it",
      hull.doubt));
  const Eigen::AlignedBox3d carved = ShrinkToHull(
      MakeSilhouettes(views, true), box, options.hull_level, context);
  return MakeRegion(
      carved.isEmpty() ? box : carved, RegionSource::kSparsePoints, options);
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
    CheckOption(finite && (box.min().array() < box.max().array()).all(),
                "bounding_box",
                fmt::format("{},{},{},{},{},{}",
                            box.min().x(),
                            box.min().y(),
                            box.min().z(),
                            box.max().x(),
                            box.max().y(),
                            box.max().z()),
                "must be x0,y0,z0,x1,y1,z1, finite and with min < max");
  }
  CheckOption(
      margin >= 0 && margin <= 10, "margin", margin, "must be in [0, 10]");
  CheckOption(mask_tolerance >= 0 && mask_tolerance <= kMaxMaskTolerance,
              "mask_tolerance",
              mask_tolerance,
              fmt::format("must be in [0, {}]", kMaxMaskTolerance));
  CheckOption(hull_level >= 2 && hull_level <= 8,
              "hull_level",
              hull_level,
              "must be in [2, 8]");
  CheckOption(point_margin >= 0 && point_margin <= 10,
              "point_margin",
              point_margin,
              "must be in [0, 10]");
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

Region EstimateRegion(const std::vector<View>& views,
                      const std::vector<Eigen::Vector3d>& points,
                      const RegionOptions& options,
                      const Context& context) {
  options.Check();
  if (options.bounding_box) {
    return MakeRegion(*options.bounding_box, RegionSource::kGiven, options);
  }
  if (views.empty()) {
    throw InputError("the region cannot be estimated without views");
  }
  const SilhouetteBox hull = BoxOfSilhouettes(views, options, context);
  return hull.sure ? MakeTolerantRegion(views, hull.box, options)
                   : FallBack(views, points, hull, options, context);
}

std::vector<size_t> PointsInsideMasks(
    const std::vector<View>& views,
    const std::vector<Eigen::Vector3d>& points) {
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
    if (inside[i] >= 2 && inside[i] >= 9 * outside[i]) {
      result.push_back(i);
    }
  }
  return result;
}

}  // namespace octacut
