#include "core/hull/hull_surface.h"

#include "core/base/parallel.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

constexpr size_t kBrickGrain = 64;

// Centre of a face in unit coordinates, the same to the last bit from both of
// its voxels.
Eigen::Vector3f FaceCenter(const Eigen::Vector3i& voxel, int face, int level) {
  Eigen::Vector3i doubled = 2 * voxel + Eigen::Vector3i::Ones();
  doubled[face / 2] += (face & 1) ? 1 : -1;
  return doubled.cast<float>() / float(2 << level);
}

bool IsInsideOctree(const HullOctree& octree, const Eigen::Vector3i& voxel) {
  return (voxel.array() >= 0).all() &&
         (voxel.array() < (1 << octree.level)).all() &&
         octree.IsInside(EncodeMorton(voxel));
}

}  // namespace

LabeledVoxels ComputeHullSurface(const ViewSet& views,
                                 const Eigen::AlignedBox3f& box,
                                 const HullOctree& octree,
                                 const Context& context) {
  LabeledVoxels crust;
  crust.voxels = VoxelGrid::FromCodes(octree.level, octree.mixed);
  crust.labels.assign(crust.voxels.Size(), 0);
  const VoxelWalk walk(crust.voxels, context);
  ParallelFor(
      context, walk.NumBricks(), kBrickGrain, [&](size_t begin, size_t end) {
        walk.ForEachWithNeighbors(
            begin, end, [&](const VoxelSlot& slot, const auto& neighbors) {
              const Eigen::Vector3i voxel = DecodeMorton(VoxelGrid::CodeOf(
                  crust.voxels.Bricks()[slot.brick], int(slot.bit)));
              for (int face = 0; face < kNumFaces; ++face) {
                // What the octree has decided about a voxel holds for all of
                // it, its faces included.
                const bool inside =
                    neighbors[face] != VoxelGrid::kNone
                        ? IsInsideHull(
                              views, box, FaceCenter(voxel, face, octree.level))
                        : IsInsideOctree(octree, NeighborVoxel(voxel, face));
                crust.labels[slot.index] |= FaceLabels(inside ? 1 << face : 0);
              }
            });
      });
  return crust;
}

LabeledVoxels ComputeHullSurface(const ViewSet& views,
                                 const Eigen::AlignedBox3f& box,
                                 const VisualHullOptions& options,
                                 const Context& context) {
  options.Check();
  return ComputeHullSurface(
      views, box, RefineHull(views, box, options.hull_level, context), context);
}

}  // namespace octacut
