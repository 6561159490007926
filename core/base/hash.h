// Random numbers that any thread may draw in any order: hashes instead of a
// generator with a state.
#pragma once

#include <cstdint>

namespace octacut {

// A well mixed 64-bit hash (the finalizer of splitmix64) of a chain of
// numbers.
inline uint64_t HashBits(uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}
template <typename... Rest>
uint64_t HashBits(uint64_t first, uint64_t second, Rest... rest) {
  return HashBits(HashBits(first) ^ second, rest...);
}

// Uniform in [0, 1).
inline double HashUniform(uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace octacut
