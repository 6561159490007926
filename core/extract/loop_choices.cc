#include "core/extract/loop_choices.h"

#include "core/base/parallel.h"
#include "core/extract/cube_topology.h"
#include "core/extract/octant_mean.h"

namespace octacut {
namespace {

using CornerOffsets = std::array<Eigen::Vector3f, 256>;

void ChooseOfVoxel(CutVoxels::Index number,
                   FaceLabels labels,
                   const UmbrellaVertices& umbrellas,
                   const CornerOffsets& offsets,
                   LoopChoices& result) {
  const SplitLoops& loops = kSplitLoopTable[labels];
  unsigned code = 0;
  uint32_t chords = 0;
  for (int i = 0; i < loops.num_loops; ++i) {
    const SplitLoop& loop = loops.loops[i];
    Eigen::Vector3f corners[8];
    for (int j = 0; j < loop.size; ++j) {
      const int k = loop.corners[j];
      corners[j] = Eigen::Vector3f(k & 1, k >> 1 & 1, k >> 2 & 1) +
                   offsets[umbrellas.Umbrella(number, labels, k)];
    }
    const int choice = ChooseTriangulation({corners, size_t(loop.size)});
    code |= unsigned(choice) << i;
    ForEachChord(loop, choice, [&](int a, int b) {
      if (const int chord = ChordNumber(a, b); chord >= 0) {
        chords |= 1u << chord;
      }
    });
  }
  result.codes[number] = uint8_t(code);
  result.chords[number] = chords;
}

}  // namespace

LoopChoices ChooseLoops(const CutVoxels& cut,
                        const UmbrellaVertices& umbrellas,
                        const Context& context) {
  CornerOffsets offsets;
  for (int octants = 0; octants < 256; ++octants) {
    offsets[octants] = OctantMean(OctantMask(octants)).cast<float>();
  }
  LoopChoices result;
  result.codes.resize(cut.Size());
  result.chords.resize(cut.Size());
  ParallelEach(
      context, cut.Crust().Bricks().size(), kBricksPerChunk, [&](size_t brick) {
        cut.ForEachInBrick(
            brick, [&](CutVoxels::Index number, int, FaceLabels labels) {
              ChooseOfVoxel(number, labels, umbrellas, offsets, result);
            });
      });
  return result;
}

}  // namespace octacut
