// Whether swept depths can be relied upon, by what other views have found on
// the way to them.
//
// Views that agree about a depth need not show the same point: a reflection
// lies at a depth of its own behind the surface that mirrors it, neighbouring
// views agree about that depth, and a burnt-out highlight matches anything.
// Such a depth claims free space where other views have found surfaces. Of
// depths that are right a tenth does so, because some of those surfaces are
// wrong; of polished metal half (docs/experiments/contradicting_depths.md).
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/evidence/depth_sweep.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

// Depths of at least this confidence are rather right than wrong.
inline constexpr float kRatherRight = 0.5f;

struct ReliableDepths {
  // Without the depths that are outvoted: in one voxel on the ray to them, or
  // beside it, more views have found a surface than at the depth itself.
  std::vector<SweptDepthMap> maps;
  // confidence[i][k] says how far a depth at sample k of map i can be relied
  // upon: 1 where few of the depths around it in its view are contradicted (or,
  // in scenes that are in doubt, nearly contradicted), 0 where many are; 0 all
  // over where few samples of the object have a depth and either a quarter of
  // all depths is contradicted or views that could see more have found next to
  // nothing.
  std::vector<std::vector<float>> confidence;
  // 0 .. 1; `confidence` has been multiplied by it.
  float scene_confidence = 1;
  // Photographs show what the object mirrors, and depths are not dense: only
  // silhouettes tell where its surface is.
  bool is_mirror = false;
  // The share of all depths that have a surface on the way to them, or within
  // a voxel of it.
  double contradicted_share = 0;
  // The share of the samples within the silhouettes that have a depth.
  double found_share = 0;
};

// `maps` holds confirmed depths, one map per view. `surrounded_share` is the
// share of the views with as many neighbours, near enough to be matched, as the
// sweep compares. `shown` says how far the photographs show the surface and not
// what it mirrors (0 .. 1): depths of mirrors have no confidence unless they
// are dense.
ReliableDepths EstimateDepthConfidence(const ViewSet& views,
                                       const VoxelGrid& hull,
                                       const std::vector<SweptDepthMap>& maps,
                                       double surrounded_share,
                                       float shown,
                                       const Context& context);

}  // namespace octacut
