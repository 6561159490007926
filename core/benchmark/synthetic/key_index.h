// Numbers 64-bit keys in the order of their first appearance.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/hash.h"

namespace octacut {

class KeyIndex {
 public:
  static constexpr uint32_t kNone = 0xffffffffu;

  explicit KeyIndex(size_t expected) {
    size_t capacity = 64;
    while (capacity < 2 * expected) {
      capacity *= 2;
    }
    table_.assign(capacity, kNone);
  }

  // The number of `key`, which it is given now if it has none.
  uint32_t Insert(uint64_t key) {
    if (2 * (keys_.size() + 1) > table_.size()) {
      Grow();
    }
    size_t slot = Slot(key);
    if (table_[slot] == kNone) {
      table_[slot] = static_cast<uint32_t>(keys_.size());
      keys_.push_back(key);
    }
    return table_[slot];
  }
  uint32_t Find(uint64_t key) const { return table_[Slot(key)]; }
  const std::vector<uint64_t>& Keys() const { return keys_; }

 private:
  // Where `key` is, or the free slot where it belongs.
  size_t Slot(uint64_t key) const {
    const size_t mask = table_.size() - 1;
    size_t slot = HashBits(key) & mask;
    while (table_[slot] != kNone && keys_[table_[slot]] != key) {
      slot = (slot + 1) & mask;
    }
    return slot;
  }
  void Grow() {
    table_.assign(2 * table_.size(), kNone);
    for (size_t i = 0; i < keys_.size(); ++i) {
      table_[Slot(keys_[i])] = static_cast<uint32_t>(i);
    }
  }

  std::vector<uint64_t> keys_;
  std::vector<uint32_t> table_;
};

}  // namespace octacut
