#include "core/crust/crust.h"

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/crust/medial_voxels.h"
#include "core/grid/count_bits.h"
#include "core/grid/morphology.h"
#include "core/grid/parallel_voxels.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

constexpr size_t kBrickGrain = 256;

void TieInterfaces(const LabelHierarchy& hierarchy,
                   const Context& context,
                   Crust* crust) {
  const VoxelGrid& voxels = crust->voxels;
  const int level = voxels.Level();
  const VoxelWalk walk(voxels, context);
  crust->ties.assign(voxels.Size(), 0);
  const auto tie_face = [&](const VoxelSlot& slot, int face) {
    if (walk.Neighbor(slot, face) != VoxelGrid::kNone) {
      return;
    }
    const MortonCode code =
        VoxelGrid::CodeOf(voxels.Bricks()[slot.brick], int(slot.bit));
    const Eigen::Vector3i across = NeighborVoxel(DecodeMorton(code), face);
    const bool inside = (across.array() >= 0).all() &&
                        (across.array() < voxels.Resolution()).all() &&
                        hierarchy.InsideFraction(across, level) > 0.5f;
    crust->ties[slot.index] |= inside ? InsideTie(face) : OutsideTie(face);
  };
  ParallelFor(
      context, walk.NumBricks(), kBrickGrain, [&](size_t begin, size_t end) {
        walk.ForEach(begin, end, [&](const VoxelSlot& slot) {
          for (int face = 0; face < kNumFaces; ++face) {
            tie_face(slot, face);
          }
        });
      });
}

void EstimatePrior(const LabelHierarchy& hierarchy,
                   const Context& context,
                   Crust* crust) {
  const VoxelGrid& voxels = crust->voxels;
  crust->prior.resize(voxels.Size());
  ParallelForVoxels(
      context, voxels, [&](VoxelGrid::Index index, MortonCode code) {
        crust->prior[index] =
            hierarchy.InsideFraction(DecodeMorton(code), voxels.Level());
      });
}

float InsideShare(FaceLabels labels) {
  return float(CountBits(labels)) / kNumFaces;
}

Crust MakeCrust(const LabelHierarchy& hierarchy,
                VoxelGrid voxels,
                const Context& context) {
  Crust crust;
  crust.voxels = std::move(voxels);
  TieInterfaces(hierarchy, context, &crust);
  EstimatePrior(hierarchy, context, &crust);
  crust.num_medial_voxels = TieMedialVoxels(
      crust.voxels, crust.prior, kMinMedialDepth, context, &crust.ties);
  return crust;
}

}  // namespace

void CrustOptions::Check() const {
  CheckOption(crust_dilation >= 1 && crust_dilation <= 8,
              "crust_dilation",
              crust_dilation,
              "must be in 1 .. 8");
}

Crust InitialCrust(const VoxelGrid& hull, const Context& context) {
  Crust crust;
  crust.voxels = hull;
  TieInterfaces(LabelHierarchy(), context, &crust);
  crust.prior.assign(hull.Size(), 1.0f);
  return crust;
}

Crust RefineCrust(const LabelHierarchy& hierarchy,
                  const CrustOptions& options,
                  const Context& context) {
  options.Check();
  const VoxelGrid proxy = Children(VoxelsOfCut(hierarchy.Finest()));
  return MakeCrust(
      hierarchy, Dilate(proxy, options.crust_dilation, context), context);
}

std::vector<uint8_t> CutAtBorder(const Crust& crust,
                                 const std::vector<FaceLabels>& labels,
                                 const Context& context,
                                 size_t* num_voxels) {
  const VoxelWalk walk(crust.voxels, context);
  std::vector<uint8_t> at_border(crust.voxels.Size(), 0);
  *num_voxels = size_t(ParallelSum(
      context, walk.NumBricks(), kBrickGrain, [&](size_t begin, size_t end) {
        int64_t sum = 0;
        walk.ForEach(begin, end, [&](const VoxelSlot& slot) {
          if (!IsCut(labels[slot.index])) {
            return;
          }
          for (int face = 0; face < kNumFaces; ++face) {
            if (walk.Neighbor(slot, face) == VoxelGrid::kNone) {
              at_border[slot.index] = 1;
            }
          }
          sum += at_border[slot.index];
        });
        return sum;
      }));
  return at_border;
}

Crust GrowCrust(const LabelHierarchy& hierarchy,
                const Crust& crust,
                const std::vector<uint8_t>& from,
                int steps,
                const Context& context) {
  return MakeCrust(
      hierarchy,
      Union(crust.voxels, Dilate(Subset(crust.voxels, from), steps, context)),
      context);
}

Crust WidenCrust(const LabelHierarchy& hierarchy,
                 const LabeledVoxels& solved,
                 VoxelGrid voxels,
                 const Context& context) {
  Crust crust;
  crust.voxels = std::move(voxels);
  TieInterfaces(hierarchy, context, &crust);
  EstimatePrior(hierarchy, context, &crust);
  ParallelForVoxels(
      context, crust.voxels, [&](VoxelGrid::Index index, MortonCode code) {
        const VoxelGrid::Index before = solved.voxels.Find(code);
        if (before != VoxelGrid::kNone) {
          crust.prior[index] = InsideShare(solved.labels[before]);
        }
      });
  return crust;
}

void AdoptCut(const std::vector<FaceLabels>& labels,
              int min_depth,
              const Context& context,
              Crust* crust) {
  for (size_t i = 0; i < labels.size(); ++i) {
    crust->prior[i] = InsideShare(labels[i]);
  }
  crust->num_medial_voxels = TieMedialVoxels(
      crust->voxels, crust->prior, min_depth, context, &crust->ties);
}

size_t EstimateVertices(int level, double area) {
  // For six objects at 512^3: 1.17 to 1.37 of EstimateSurfaceArea's.
  constexpr double kVerticesPerSquare = 1.3;
  const double resolution = double(1u << level);
  return size_t(kVerticesPerSquare * area * resolution * resolution);
}

size_t EstimateCrustVoxels(int level,
                           double area,
                           const CrustOptions& options) {
  // As many in each layer: 6.5 to 8.3 in all on the same objects.
  return EstimateVertices(level, area) * (2 + 2 * options.crust_dilation);
}

}  // namespace octacut
