// Names of the nodes of the octahedral graph: a node is the low face of a
// voxel, shared with the voxel below it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/cut/octahedron.h"
#include "core/grid/voxel_walk.h"

namespace octacut {

// The node on the low face of axis `axis` of the voxel at `slot`.
struct FaceNode {
  VoxelSlot slot;
  uint32_t axis;
};

// The same with its axis known when compiled, and the voxel below the face.
template <int kAxis>
struct AxisNode {
  VoxelSlot slot;
  VoxelSlot low;
};

// A voxel of a list of nodes of one axis, in 32 bits: brick (26 bits),
// position in it (6).
using NodeId = uint32_t;
inline constexpr size_t kMaxCutBricks = size_t{1} << 26;
inline NodeId IdOf(const VoxelSlot& slot) { return slot.brick << 6 | slot.bit; }

// The words of a node of no forest, and of a face that is no node; those of
// nodes on the source side are < 0: source nodes, and in the end what these
// reach. See SearchForest.
inline constexpr int32_t kFreeNode = 8;
inline constexpr int32_t kNoNode = 15;
inline constexpr int32_t kSourceNode = -120;
inline constexpr int32_t kReachedNode = -56;
inline bool IsSourceNode(int32_t word) { return word < 0; }

}  // namespace octacut
