#include "core/hull/visual_hull.h"

#include <algorithm>

#include "core/base/check_option.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 256;

// Voxels still to be refined, and those known to lie inside with all their
// descendants.
struct Front {
  std::vector<MortonCode> mixed;
  std::vector<MortonCode> inside;
};

Footprint ClassifyVoxel(const ViewSet& views,
                        const Eigen::AlignedBox3f& box,
                        MortonCode code,
                        int level) {
  const float edge = 1.0f / float(1 << level);
  const Eigen::Vector3f corner = DecodeMorton(code).cast<float>() * edge;
  const Eigen::AlignedBox3f cell(corner,
                                 corner + Eigen::Vector3f::Constant(edge));
  if (!box.intersects(cell)) {
    return Footprint::kBackground;
  }
  bool inside = box.contains(cell);
  for (const PreparedView& view : views) {
    const Footprint footprint =
        view.silhouette.TestCube(view.projection, cell.center(), edge / 2);
    if (footprint == Footprint::kBackground) {
      return Footprint::kBackground;
    }
    inside = inside && footprint == Footprint::kObject;
  }
  return inside ? Footprint::kObject : Footprint::kMixed;
}

void TestFront(const ViewSet& views,
               const Eigen::AlignedBox3f& box,
               int level,
               const Context& context,
               Front* front) {
  std::vector<Footprint> classes(front->mixed.size());
  ParallelFor(context, classes.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      classes[i] = ClassifyVoxel(views, box, front->mixed[i], level);
    }
  });
  size_t kept = 0;
  for (size_t i = 0; i < classes.size(); ++i) {
    if (classes[i] == Footprint::kObject) {
      front->inside.push_back(front->mixed[i]);
    } else if (classes[i] == Footprint::kMixed) {
      front->mixed[kept++] = front->mixed[i];
    }
  }
  front->mixed.resize(kept);
}

void RefineCodes(std::vector<MortonCode>* codes) {
  std::vector<MortonCode> children;
  children.reserve(codes->size() * 8);
  for (const MortonCode code : *codes) {
    for (MortonCode child = 0; child < 8; ++child) {
      children.push_back(FirstChildCode(code) + child);
    }
  }
  *codes = std::move(children);
}

}  // namespace

void VisualHullOptions::Check() const {
  CheckOption(hull_level >= 2 && hull_level <= 10,
              "hull_level",
              hull_level,
              "must be in 2 .. 10");
}

VisualHull ComputeVisualHull(const ViewSet& views,
                             const Eigen::AlignedBox3f& box,
                             const VisualHullOptions& options,
                             const Context& context) {
  options.Check();
  Phase phase(context, "visual hull", size_t(options.hull_level) + 1);
  VisualHull hull;
  Front front;
  front.mixed.push_back(0);
  for (int level = 0; level <= options.hull_level; ++level) {
    hull.summary.tested_voxels.push_back(front.mixed.size());
    TestFront(views, box, level, context, &front);
    if (level < options.hull_level) {
      RefineCodes(&front.mixed);
      RefineCodes(&front.inside);
    }
    phase.Advance();
  }
  front.mixed.insert(
      front.mixed.end(), front.inside.begin(), front.inside.end());
  hull.voxels =
      VoxelGrid::FromCodes(options.hull_level, std::move(front.mixed));
  hull.summary.num_voxels = hull.voxels.Size();
  if (hull.voxels.Empty()) {
    throw InputError(
        "the visual hull is empty: no part of the region is object in every "
        "view (do masks and cameras belong together, and is the bounding box "
        "right?)");
  }
  return hull;
}

bool IsInsideHull(const ViewSet& views,
                  const Eigen::AlignedBox3f& box,
                  const Eigen::Vector3f& point) {
  if (!box.contains(point)) {
    return false;
  }
  constexpr float kHalfCovered = 127.5f;
  for (const PreparedView& view : views) {
    const Eigen::Vector3f h = view.projection.Homogeneous(point);
    if (h.z() > 0 &&
        view.silhouette.Coverage(h.x() / h.z(), h.y() / h.z()) < kHalfCovered) {
      return false;
    }
  }
  return true;
}

}  // namespace octacut
