// The crust of a level: the voxels in which the surface is looked for, with
// what is known about their inside and outside beforehand [HK06 section 3].
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/context.h"
#include "core/crust/label_hierarchy.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

struct CrustOptions {
  // Times that the proxy surface is dilated (d of the paper); 1 .. 8.
  // Wider crusts gain nothing: docs/experiments/crusts.md.
  int crust_dilation = 2;
  // Voxels from the surface of the coarser level to the border of the crust.
  int HalfWidth() const { return crust_dilation + 1; }
  void Check() const;
};

struct Crust {
  VoxelGrid voxels;
  // Ties at the interfaces to the interior and to the exterior, and at the
  // medial voxels of parts too thin to have an interior of their own.
  std::vector<FaceTies> ties;
  // Share of the voxel that lies inside as far as coarser levels know, 0 .. 1.
  std::vector<float> prior;
  size_t num_medial_voxels = 0;
};

// The crust of l0: every voxel of the hull. All interfaces are exterior; what
// lies inside is for the evidence to say.
Crust InitialCrust(const VoxelGrid& hull, const Context& context);

// The crust of the level after hierarchy.Finest(): the children of its cut
// voxels, two layers, dilated `crust_dilation` times on both sides: about six
// voxels. Voxels outside the crust are inside or outside by the
// coarser cuts. Where a structure (or a gap) is so thin that the crust spans
// it, its medial voxels are tied, so that a minimal cut can neither amputate
// the structure nor fill the gap.
Crust RefineCrust(const LabelHierarchy& hierarchy,
                  const CrustOptions& options,
                  const Context& context);

// The cut voxels that touch the crust's border, as one flag per voxel; their
// number comes back in `num_voxels`.
std::vector<uint8_t> CutAtBorder(const Crust& crust,
                                 const std::vector<FaceLabels>& labels,
                                 const Context& context,
                                 size_t* num_voxels);

// `crust` grown by `steps` dilations around the voxels that `from` flags.
Crust GrowCrust(const LabelHierarchy& hierarchy,
                const Crust& crust,
                const std::vector<uint8_t>& from,
                int steps,
                const Context& context);

// A crust of the same level as `solved`, whose voxels `voxels` holds: `prior`
// is what was solved, beyond that what coarser levels know. No medial voxels
// are tied.
Crust WidenCrust(const LabelHierarchy& hierarchy,
                 const LabeledVoxels& solved,
                 VoxelGrid voxels,
                 const Context& context);

// Takes a cut of the crust for what is known of inside and outside, and ties
// the medial voxels by it that are at least `min_depth` deep.
void AdoptCut(const std::vector<FaceLabels>& labels,
              int min_depth,
              const Context& context,
              Crust* crust);

// Roughly, the vertices of the mesh of a level, and the voxels of the crust,
// for a surface of that area in unit coordinates.
size_t EstimateVertices(int level, double area);
size_t EstimateCrustVoxels(int level, double area, const CrustOptions& options);

}  // namespace octacut
