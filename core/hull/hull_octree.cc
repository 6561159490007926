#include "core/hull/hull_octree.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 256;

Containment ClassifyVoxel(const ViewSet& views,
                          const Eigen::AlignedBox3f& box,
                          MortonCode code,
                          int level) {
  const float edge = 1.0f / float(1 << level);
  const Eigen::Vector3f corner = DecodeMorton(code).cast<float>() * edge;
  const Eigen::AlignedBox3f cell(corner,
                                 corner + Eigen::Vector3f::Constant(edge));
  if (!box.intersects(cell)) {
    return Containment::kBackground;
  }
  bool inside = box.contains(cell);
  for (const PreparedView& view : views) {
    const Containment containment = view.silhouette.TestCube(
        view.projection, cell.center(), edge / 2, view.mask_tolerance);
    if (containment == Containment::kBackground) {
      return Containment::kBackground;
    }
    inside = inside && containment == Containment::kObject;
  }
  return inside ? Containment::kObject : Containment::kMixed;
}

// Sorts the mixed voxels of the octree's level into mixed, inside, outside.
void TestMixed(const ViewSet& views,
               const Eigen::AlignedBox3f& box,
               const Context& context,
               HullOctree* octree) {
  std::vector<Containment> classes(octree->mixed.size());
  ParallelEach(context, classes.size(), kGrain, [&](size_t i) {
    classes[i] = ClassifyVoxel(views, box, octree->mixed[i], octree->level);
  });
  octree->tested_voxels.push_back(classes.size());
  std::vector<MortonCode>& inside = octree->inside.emplace_back();
  size_t kept = 0;
  for (size_t i = 0; i < classes.size(); ++i) {
    if (classes[i] == Containment::kObject) {
      inside.push_back(octree->mixed[i]);
    } else if (classes[i] == Containment::kMixed) {
      octree->mixed[kept++] = octree->mixed[i];
    }
  }
  octree->mixed.resize(kept);
}

std::vector<MortonCode> ChildCodes(const std::vector<MortonCode>& codes) {
  std::vector<MortonCode> children;
  children.reserve(codes.size() * 8);
  for (const MortonCode code : codes) {
    for (MortonCode child = 0; child < 8; ++child) {
      children.push_back(FirstChildCode(code) + child);
    }
  }
  return children;
}

}  // namespace

bool HullOctree::IsInside(MortonCode code) const {
  for (int ancestor = level; ancestor >= 0; --ancestor) {
    const std::vector<MortonCode>& codes = inside[ancestor];
    if (std::binary_search(codes.begin(), codes.end(), code)) {
      return true;
    }
    code = ParentCode(code);
  }
  return false;
}

bool HullOctree::IsEmpty() const {
  return mixed.empty() &&
         std::all_of(inside.begin(), inside.end(), [](const auto& codes) {
           return codes.empty();
         });
}

HullOctree RefineHull(const ViewSet& views,
                      const Eigen::AlignedBox3f& box,
                      int level,
                      const Context& context) {
  Phase phase(context, "visual hull", size_t(level) + 1);
  HullOctree octree;
  octree.mixed.push_back(0);
  TestMixed(views, box, context, &octree);
  phase.Advance();
  while (octree.level < level) {
    octree.mixed = ChildCodes(octree.mixed);
    ++octree.level;
    TestMixed(views, box, context, &octree);
    phase.Advance();
  }
  if (octree.IsEmpty()) {
    throw InputError(
        "the visual hull is empty: no point of the region is object in every "
        "mask. Check that the masks belong to these cameras and that the "
        "bounding box is correct");
  }
  return octree;
}

}  // namespace octacut
