// Lists of nodes by level, in chunks from a common pool, so that together
// they take what is queued now and not what every level once held.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace octacut {

class ChunkPool {
 public:
  static constexpr uint32_t kNone = 0xffffffffu;
  struct Chunk {
    uint32_t next;
    uint32_t size;
    uint32_t items[62];
  };

  uint32_t Allocate() {
    uint32_t chunk = free_;
    if (chunk != kNone) {
      free_ = At(chunk).next;
    } else {
      if (num_chunks_ % kBlock == 0) {
        blocks_.push_back(std::make_unique_for_overwrite<Chunk[]>(kBlock));
      }
      chunk = num_chunks_++;
    }
    At(chunk).next = kNone;
    At(chunk).size = 0;
    return chunk;
  }
  void Free(uint32_t chunk) {
    At(chunk).next = free_;
    free_ = chunk;
  }
  Chunk& At(uint32_t chunk) { return blocks_[chunk / kBlock][chunk % kBlock]; }
  size_t MemoryBytes() const { return blocks_.size() * kBlock * sizeof(Chunk); }

 private:
  static constexpr uint32_t kBlock = 16;
  std::vector<std::unique_ptr<Chunk[]>> blocks_;
  uint32_t num_chunks_ = 0;
  uint32_t free_ = kNone;
};

// A list; first in, first out.
class ChunkList {
 public:
  bool Empty() const { return head_ == ChunkPool::kNone; }
  size_t Size() const { return size_; }

  void Add(uint32_t item, ChunkPool& pool) {
    if (tail_ == ChunkPool::kNone) {
      head_ = tail_ = pool.Allocate();
    } else if (pool.At(tail_).size == std::size(ChunkPool::Chunk{}.items)) {
      const uint32_t chunk = pool.Allocate();
      pool.At(tail_).next = chunk;
      tail_ = chunk;
    }
    ChunkPool::Chunk& chunk = pool.At(tail_);
    chunk.items[chunk.size++] = item;
    ++size_;
  }

  // Takes all items that are in the list now: prefetch(item) some items ahead
  // of body(item). The body may add to this and to other lists.
  template <typename Prefetch, typename Body>
  void Consume(ChunkPool& pool, Prefetch&& prefetch, Body&& body) {
    constexpr uint32_t kAhead = 6;
    uint32_t chunk = head_;
    *this = ChunkList();
    while (chunk != ChunkPool::kNone) {
      // Blocks never move, so the chunk stays where it is.
      const ChunkPool::Chunk& items = pool.At(chunk);
      for (uint32_t k = 0; k < items.size; ++k) {
        if (k + kAhead < items.size) {
          prefetch(items.items[k + kAhead]);
        }
        body(items.items[k]);
      }
      const uint32_t next = items.next;
      pool.Free(chunk);
      chunk = next;
    }
  }

 private:
  uint32_t head_ = ChunkPool::kNone;
  uint32_t tail_ = ChunkPool::kNone;
  size_t size_ = 0;
};

// One list a level.
class BucketQueue {
 public:
  void Add(int32_t level, uint32_t item, ChunkPool& pool) {
    if (size_t(level) >= levels_.size()) {
      levels_.resize(size_t(level) + size_t(level) / 2 + 16);
    }
    levels_[level].Add(item, pool);
    lowest_ = std::min(lowest_, level);
    highest_ = std::max(highest_, level);
    ++size_;
  }
  bool Empty() const { return size_ == 0; }
  size_t Size() const { return size_; }
  // The least and greatest levels that may hold items; of an empty queue
  // Lowest() > Highest().
  int32_t Lowest() {
    while (lowest_ <= highest_ && levels_[lowest_].Empty()) {
      ++lowest_;
    }
    if (lowest_ > highest_) {
      lowest_ = kNoLevel;
      highest_ = -1;
    }
    return lowest_;
  }
  int32_t Highest() const { return highest_; }
  // Moves a level's list out.
  ChunkList Take(int32_t level) {
    size_ -= levels_[level].Size();
    return std::exchange(levels_[level], {});
  }

 private:
  static constexpr int32_t kNoLevel = 0x7fffffff;
  std::vector<ChunkList> levels_;
  int32_t lowest_ = kNoLevel;
  int32_t highest_ = -1;
  size_t size_ = 0;
};

}  // namespace octacut
