// Morton codes of coordinates of cells: bit 3i is bit i of x, 3i + 1 of y,
// 3i + 2 of z. Coordinates up to 2^21 - 1.
#pragma once

#include <cstdint>
#include <Eigen/Core>

namespace octacut {

using MortonCode = uint64_t;

namespace internal {

inline constexpr uint64_t SpreadBits(uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x001f00000000ffffull;
  x = (x | x << 16) & 0x001f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  x = (x | x << 2) & 0x1249249249249249ull;
  return x;
}

inline constexpr uint64_t GatherBits(uint64_t x) {
  x &= 0x1249249249249249ull;
  x = (x ^ (x >> 2)) & 0x10c30c30c30c30c3ull;
  x = (x ^ (x >> 4)) & 0x100f00f00f00f00full;
  x = (x ^ (x >> 8)) & 0x001f0000ff0000ffull;
  x = (x ^ (x >> 16)) & 0x001f00000000ffffull;
  x = (x ^ (x >> 32)) & 0x00000000001fffffull;
  return x;
}

}  // namespace internal

inline constexpr MortonCode EncodeMorton(uint32_t x, uint32_t y, uint32_t z) {
  return internal::SpreadBits(x) | internal::SpreadBits(y) << 1 |
         internal::SpreadBits(z) << 2;
}
inline MortonCode EncodeMorton(const Eigen::Vector3i& voxel) {
  return EncodeMorton(voxel.x(), voxel.y(), voxel.z());
}
inline Eigen::Vector3i DecodeMorton(MortonCode code) {
  return {int(internal::GatherBits(code)),
          int(internal::GatherBits(code >> 1)),
          int(internal::GatherBits(code >> 2))};
}

inline constexpr MortonCode ParentCode(MortonCode code) { return code >> 3; }
inline constexpr MortonCode FirstChildCode(MortonCode code) {
  return code << 3;
}

}  // namespace octacut
