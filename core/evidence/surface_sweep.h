// Depths around a surface that is nearly right, at its own scale. For
// core/evidence alone.
#pragma once

#include <vector>

#include "core/evidence/depth_sweep.h"
#include "core/evidence/sweep_view.h"
#include "core/grid/voxel_values.h"

namespace octacut {

// Sweeps views in small squares of samples, each from just before the surface
// that it shows to some way into it.
class SurfaceSweep {
 public:
  // `views` are reduced for the surface's cut voxels, of `level`;
  // `depth_confidence` is that of InsideEvidence. Keeps references to all of
  // them.
  SurfaceSweep(const std::vector<SweepView>& views,
               const VoxelValues& depth_confidence,
               int level,
               const DepthSweepOptions& options);

  // Without depths, for AddDepths.
  SweptDepthMap EmptyMap(int view) const;
  // Depths of the squares that show the surface where depths are rather right
  // than wrong; in a sample of space (an eighth of its blocks), or in the rest.
  // `neighbors` of the view are compared with it.
  void AddDepths(int view,
                 const std::vector<int>& neighbors,
                 bool of_sample,
                 SweptDepthMap* map) const;

 private:
  struct Square;
  bool IsWanted(const SweepView& view,
                const Square& square,
                bool of_sample) const;
  void SweepSquare(const SweepView& view,
                   const Square& square,
                   const std::vector<int>& others,
                   std::vector<SweepView>* compared,
                   SweptDepthMap* map) const;

  const std::vector<SweepView>& views_;
  const VoxelValues& depth_confidence_;
  float voxel_;
  const DepthSweepOptions& options_;
};

}  // namespace octacut
