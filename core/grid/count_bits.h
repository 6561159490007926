// The number of bits that are set, inline: std::popcount is a library call
// where the processor may be any that runs Debian.
#pragma once

#include <cstdint>

namespace octacut {

inline constexpr int CountBits(uint64_t x) {
  x -= x >> 1 & 0x5555555555555555ull;
  x = (x & 0x3333333333333333ull) + (x >> 2 & 0x3333333333333333ull);
  x = (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0full;
  return int(x * 0x0101010101010101ull >> 56);
}

}  // namespace octacut
