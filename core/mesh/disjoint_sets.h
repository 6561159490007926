// Sets of numbers that are united one after another.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace octacut {

class DisjointSets {
 public:
  explicit DisjointSets(size_t size = 0) { Reset(size); }

  // Each of 0 .. size - 1 in a set of its own.
  void Reset(size_t size) {
    parents_.resize(size);
    std::iota(parents_.begin(), parents_.end(), 0u);
  }

  // The lowest number of the set.
  uint32_t Find(uint32_t i) {
    while (parents_[i] != i) {
      i = parents_[i] = parents_[parents_[i]];
    }
    return i;
  }

  // Whether the two were in different sets.
  bool Unite(uint32_t a, uint32_t b) {
    a = Find(a);
    b = Find(b);
    if (a == b) {
      return false;
    }
    parents_[std::max(a, b)] = std::min(a, b);
    return true;
  }

 private:
  std::vector<uint32_t> parents_;
};

}  // namespace octacut
