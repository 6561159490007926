// The ground truth of ETH3D: laser scans with their poses.
#pragma once

#include <filesystem>
#include <vector>

#include "core/benchmark/protocols/eth3d.h"

namespace octacut {

// Reads a MeshLab project (scan_alignment.mlp) and the clouds that it names,
// relative to its folder. As in the benchmark's program, only the first group
// of meshes counts. Throws InputError that names the file and the element.
std::vector<LaserScan> ReadLaserScans(const std::filesystem::path& path);

}  // namespace octacut
