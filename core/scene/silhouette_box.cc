#include "core/scene/silhouette_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

// Shrinks the box to the hull inside it until nothing changes.
Eigen::AlignedBox3d Shrink(const std::vector<SilhouettePyramid>& silhouettes,
                           Eigen::AlignedBox3d box,
                           int level,
                           const Context& context,
                           size_t max_denials = 0) {
  // Pieces are told apart only once cells are small against the object.
  double min_fraction = 0;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const CoarseHull hull =
        CarveBox(silhouettes, box, level, context, max_denials);
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

// What a box of bounded silhouettes stays within.
Eigen::AlignedBox3d Interior(const Eigen::AlignedBox3d& search) {
  const Eigen::Vector3d slack =
      Eigen::Vector3d::Constant(1e-6 * search.sizes().x());
  return {search.min() + slack, search.max() - slack};
}

bool AllOnOneSide(const std::vector<View>& views,
                  const Eigen::Vector3d& center) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const View& view : views) {
    sum += (view.Center() - center).normalized();
  }
  return sum.norm() > kOneSided * double(views.size());
}

// Names the one mask without which the others have points in common, if there
// is just one: among hundreds it is hard to find by eye.
[[noreturn]] void RefuseMasks(const std::vector<View>& views,
                              const Eigen::AlignedBox3d& search,
                              int level,
                              const Context& context) {
  std::vector<SilhouettePyramid> silhouettes = MakeSilhouettes(views, false);
  std::vector<size_t> culprits;
  for (size_t i = 0; i < views.size() && culprits.size() < 2; ++i) {
    context.ThrowIfCancelled();
    std::swap(silhouettes[i], silhouettes.back());
    const SilhouettePyramid left_out = std::move(silhouettes.back());
    silhouettes.pop_back();
    if (!Shrink(silhouettes, search, level, context).isEmpty()) {
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
                "all masks except that of {} fit; check this mask and its pose",
                views[culprits.front()].name)
          : "the masks may be wrong, inverted, or made for another image "
            "geometry"));
}

}  // namespace

SilhouetteBox BoxOfSilhouettes(const std::vector<View>& views,
                               int level,
                               const Context& context) {
  const Eigen::AlignedBox3d search = SearchBox(views);
  if (!(search.sizes().x() > 0)) {
    return {{}, false, "all cameras are at the same position"};
  }
  const Eigen::AlignedBox3d interior = Interior(search);
  // Views that cut the object off bound it only if the others do not: their
  // untouched sides need the object not to turn back outside of the frame.
  for (const bool trust_sides : {false, true}) {
    const Eigen::AlignedBox3d box =
        ShrinkToHull(views, trust_sides, search, level, context);
    if (box.isEmpty()) {
      RefuseMasks(views, search, level, context);
    }
    if (interior.contains(box)) {
      if (AllOnOneSide(views, box.center())) {
        return {box, false, "all cameras are on the same side of it"};
      }
      return {box, !trust_sides, "it leaves the frame in too many views"};
    }
  }
  return {{}, false, "it leaves the frame, or the views are too similar"};
}

Eigen::AlignedBox3d BoxOfMostSilhouettes(const std::vector<View>& views,
                                         size_t max_denials,
                                         int level,
                                         const Context& context) {
  const Eigen::AlignedBox3d search = SearchBox(views);
  if (!(search.sizes().x() > 0)) {
    return {};
  }
  for (const bool trust_sides : {false, true}) {
    const Eigen::AlignedBox3d box = Shrink(MakeSilhouettes(views, trust_sides),
                                           search,
                                           level,
                                           context,
                                           max_denials);
    if (!box.isEmpty() && Interior(search).contains(box)) {
      return box;
    }
  }
  return {};
}

Eigen::AlignedBox3d ShrinkToHull(const std::vector<View>& views,
                                 bool trust_sides,
                                 const Eigen::AlignedBox3d& box,
                                 int level,
                                 const Context& context) {
  return Shrink(MakeSilhouettes(views, trust_sides), box, level, context);
}

}  // namespace octacut
