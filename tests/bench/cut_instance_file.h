// One cut problem in a file, little endian: u64 magic, u64 resolution, u64 N;
// N x u16[3] voxel x y z in Morton order; N x f32 weight; N x u16 ties (bit d:
// face d tied outside, bit 6 + d: inside). With evidence another magic and
// N x f32 evidence at the end.
#pragma once

#include <string>

#include "tests/bench/cut_instances.h"

namespace octacut {

// Throws InputError naming the file when it is not an instance.
CutInstance ReadCutInstance(const std::string& path);
// Both write as WriteFile does: all of the file or nothing.
void WriteCutInstance(const CutInstance& instance, const std::string& path);
// One byte per voxel: its labels.
void WriteCutLabels(const std::vector<FaceLabels>& labels,
                    const std::string& path);

}  // namespace octacut
