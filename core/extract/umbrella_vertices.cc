#include "core/extract/umbrella_vertices.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

// The eight cells of a block around corner `k` of a cell, by octant.
struct CornerCells {
  CornerCells(int cell, int k) {
    constexpr int kStride[3] = {
        1, CutBlock::kSide, CutBlock::kSide * CutBlock::kSide};
    for (int octant = 0; octant < 8; ++octant) {
      cells[octant] = cell;
      for (int axis = 0; axis < 3; ++axis) {
        // The voxel itself lies in octant 7 ^ k.
        const int step = (octant >> axis & 1) - ((7 ^ k) >> axis & 1);
        cells[octant] += step * kStride[axis];
      }
    }
  }
  int cells[8];
};

[[noreturn]] void ThrowNotClosed(const CutVoxels& cut,
                                 size_t brick,
                                 int bit,
                                 const char* reason) {
  const Eigen::Vector3i voxel =
      DecodeMorton(VoxelGrid::CodeOf(cut.Crust().Bricks()[brick], bit));
  throw InputError(fmt::format("face labels around voxel ({}, {}, {}): {}",
                               voxel.x(),
                               voxel.y(),
                               voxel.z(),
                               reason));
}

// Labels of the twelve quarter faces around a corner. A voxel outside the
// crust is inside or outside as a whole, so one face tells the other two.
// Returns null, or what is wrong.
const char* QuarterFaces(const CutBlock& block,
                         const CornerCells& around,
                         QuarterFaceLabels* labels) {
  unsigned known = 0;
  unsigned inside = 0;
  unsigned unknown_octants = 0;
  for (int octant = 0; octant < 8; ++octant) {
    const uint8_t voxel_labels = block.Labels(around.cells[octant]);
    if (voxel_labels == CutBlock::kUnknown) {
      unknown_octants |= 1u << octant;
      continue;
    }
    const unsigned faces = QuarterFacesOfOctant(octant);
    const unsigned mine = kQuarterFaceTable[octant][voxel_labels];
    if (((inside ^ mine) & known & faces) != 0) {
      return "two voxels disagree about a face they share";
    }
    known |= faces;
    inside |= mine;
  }
  while (unknown_octants != 0) {
    for (int octant = 0; octant < 8; ++octant) {
      const unsigned faces = QuarterFacesOfOctant(octant);
      if ((unknown_octants >> octant & 1) == 0 || (known & faces) == 0) {
        continue;
      }
      const unsigned seen = inside & known & faces;
      if (seen != 0 && seen != (known & faces)) {
        return "the surface ends at the border of the crust";
      }
      known |= faces;
      inside |= seen != 0 ? faces : 0;
      unknown_octants &= ~(1u << octant);
    }
  }
  *labels = QuarterFaceLabels(inside);
  return nullptr;
}

// Whether the voxel in `octant` comes first in the umbrella.
bool IsFirst(const CutBlock& block,
             const CornerCells& around,
             OctantMask umbrella,
             int octant) {
  const CutVoxels::Index mine = block.Number(around.cells[octant]);
  for (unsigned rest = umbrella; rest != 0; rest &= rest - 1) {
    if (block.Number(around.cells[std::countr_zero(rest)]) < mine) {
      return false;
    }
  }
  return true;
}

int CellOfBit(int bit) {
  return CutBlock::Cell(CoordinateInBrick(bit, 0),
                        CoordinateInBrick(bit, 1),
                        CoordinateInBrick(bit, 2));
}

// Calls body(corner) for the corners of a mask.
template <typename Body>
void ForEachCorner(unsigned mask, Body&& body) {
  for (; mask != 0; mask &= mask - 1) {
    body(std::countr_zero(mask));
  }
}

struct VertexCount {
  uint32_t vertices = 0;
  uint32_t extra = 0;
};

// Fills in the umbrellas of a brick's slots and counts the vertices whose
// umbrella begins there.
VertexCount FindUmbrellas(const CutVoxels& cut,
                          size_t brick,
                          CutBlock& block,
                          UmbrellaVertices& result) {
  block.Load(cut, brick);
  VertexCount count;
  cut.ForEachInBrick(
      brick, [&](CutVoxels::Index number, int bit, FaceLabels voxel_labels) {
        size_t slot = result.first_slot[number];
        const int cell = CellOfBit(bit);
        ForEachCorner(kSplitLoopTable[voxel_labels].corner_mask, [&](int k) {
          const CornerCells around(cell, k);
          QuarterFaceLabels labels = 0;
          if (const char* reason = QuarterFaces(block, around, &labels)) {
            ThrowNotClosed(cut, brick, bit, reason);
          }
          const CornerUmbrellas& umbrellas = kCornerUmbrellaTable[labels];
          const OctantMask mine = umbrellas.of_octant[7 ^ k];
          result.umbrellas[slot++] = mine;
          result.near_four_polygon_edge[number] |=
              umbrellas.has_four_polygon_edge;
          if (IsFirst(block, around, mine, 7 ^ k)) {
            ++count.vertices;
            // Extra unless this is the umbrella of the lowest octant.
            const OctantMask* first = umbrellas.of_octant.data();
            while (*first == 0) {
              ++first;
            }
            count.extra += *first != mine;
          }
        });
      });
  return count;
}

// Numbers the vertices whose umbrella begins in a brick, from `next` on.
uint32_t NumberVertices(const CutVoxels& cut,
                        const BoundingCube& cube,
                        size_t brick,
                        CutBlock& block,
                        uint32_t next,
                        UmbrellaVertices& result) {
  const double voxel_size = cube.VoxelSize(cut.Crust().Level());
  const VoxelGrid::Brick& bits = cut.Crust().Bricks()[brick];
  block.Load(cut, brick);
  cut.ForEachInBrick(
      brick, [&](CutVoxels::Index number, int bit, FaceLabels labels) {
        size_t slot = result.first_slot[number];
        const Eigen::Vector3i voxel =
            DecodeMorton(VoxelGrid::CodeOf(bits, bit));
        const int cell = CellOfBit(bit);
        ForEachCorner(kSplitLoopTable[labels].corner_mask, [&](int k) {
          const CornerCells around(cell, k);
          const OctantMask umbrella = result.umbrellas[slot++];
          if (!IsFirst(block, around, umbrella, 7 ^ k)) {
            return;
          }
          const Eigen::Vector3i corner =
              voxel + Eigen::Vector3i(k & 1, k >> 1 & 1, k >> 2 & 1);
          result.positions[next] =
              cube.min_corner + voxel_size * corner.cast<double>();
          result.octants[next] = umbrella;
          ForEachCorner(umbrella, [&](int octant) {
            const int other = around.cells[octant];
            const size_t other_slot = result.Slot(
                block.Number(other), block.Labels(other), 7 ^ octant);
            result.vertices[other_slot] = next;
          });
          ++next;
        });
      });
  return next;
}

// Returns the number of slots.
size_t NumberSlots(const CutVoxels& cut, std::vector<uint32_t>& first_slot) {
  first_slot.resize(cut.Size());
  size_t num_slots = 0;
  for (size_t brick = 0; brick < cut.Crust().Bricks().size(); ++brick) {
    cut.ForEachInBrick(
        brick, [&](CutVoxels::Index number, int, FaceLabels labels) {
          first_slot[number] = uint32_t(num_slots);
          num_slots +=
              std::popcount(unsigned(kSplitLoopTable[labels].corner_mask));
        });
  }
  if (num_slots > 0xffffffffu) {
    throw Error(fmt::format("a surface with {} polygon corners is too large",
                            num_slots));
  }
  return num_slots;
}

}  // namespace

UmbrellaVertices FindUmbrellaVertices(const CutVoxels& cut,
                                      const BoundingCube& cube,
                                      const Context& context) {
  UmbrellaVertices result;
  const size_t num_slots = NumberSlots(cut, result.first_slot);
  result.near_four_polygon_edge.resize(cut.Size());
  result.umbrellas.resize(num_slots);
  result.vertices.resize(num_slots);

  const size_t num_bricks = cut.Crust().Bricks().size();
  std::vector<VertexCount> counts(NumChunks(num_bricks, kBricksPerChunk));
  ParallelChunks(context,
                 num_bricks,
                 kBricksPerChunk,
                 [&](size_t chunk, size_t begin, size_t end) {
                   CutBlock block;
                   for (size_t brick = begin; brick < end; ++brick) {
                     if (cut.Mask(brick) == 0) {
                       continue;
                     }
                     const VertexCount count =
                         FindUmbrellas(cut, brick, block, result);
                     counts[chunk].vertices += count.vertices;
                     counts[chunk].extra += count.extra;
                   }
                 });
  uint32_t num_vertices = 0;
  for (VertexCount& count : counts) {
    result.num_extra += count.extra;
    const uint32_t first = num_vertices;
    num_vertices += count.vertices;
    count.vertices = first;
  }
  result.positions.resize(num_vertices);
  result.octants.resize(num_vertices);
  ParallelChunks(context,
                 num_bricks,
                 kBricksPerChunk,
                 [&](size_t chunk, size_t begin, size_t end) {
                   CutBlock block;
                   uint32_t next = counts[chunk].vertices;
                   for (size_t brick = begin; brick < end; ++brick) {
                     if (cut.Mask(brick) != 0) {
                       next = NumberVertices(
                           cut, cube, brick, block, next, result);
                     }
                   }
                 });
  return result;
}

}  // namespace octacut
