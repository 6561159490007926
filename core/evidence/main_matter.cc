#include "core/evidence/main_matter.h"

#include <algorithm>
#include <cstddef>

namespace octacut {
namespace {

// A part with less than this fraction of the largest part is a crumb.
constexpr size_t kCrumb = 10;

}  // namespace

std::vector<uint8_t> FindMainMatter(const VoxelGrid& voxels,
                                    const std::vector<FaceLabels>& labels) {
  constexpr uint32_t kNoPart = 0;
  std::vector<uint32_t> part(voxels.Size(), kNoPart);
  std::vector<size_t> sizes = {0};  // of parts, from 1 on
  std::vector<Eigen::Vector3i> open;
  const auto add = [&](VoxelGrid::Index index, const Eigen::Vector3i& voxel) {
    if (labels[index] == kAllFaces && part[index] == kNoPart) {
      part[index] = uint32_t(sizes.size() - 1);
      ++sizes.back();
      open.push_back(voxel);
    }
  };
  voxels.ForEach([&](VoxelGrid::Index seed, MortonCode code) {
    if (labels[seed] != kAllFaces || part[seed] != kNoPart) {
      return;
    }
    sizes.push_back(0);
    add(seed, DecodeMorton(code));
    while (!open.empty()) {
      const Eigen::Vector3i voxel = open.back();
      open.pop_back();
      for (int face = 0; face < kNumFaces; ++face) {
        const Eigen::Vector3i beside = NeighborVoxel(voxel, face);
        const VoxelGrid::Index index = voxels.Find(beside);
        if (index != VoxelGrid::kNone) {
          add(index, beside);
        }
      }
    }
  });
  const size_t largest = *std::max_element(sizes.begin(), sizes.end());
  std::vector<uint8_t> is_main(voxels.Size());
  for (size_t i = 0; i < is_main.size(); ++i) {
    is_main[i] = part[i] != kNoPart && sizes[part[i]] * kCrumb >= largest;
  }
  return is_main;
}

}  // namespace octacut
