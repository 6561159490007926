// Lists of nodes by level and axis, in chunks from a common pool, so that
// together they take what is queued now and not what every level once held.
// Lists by axis let the code that takes them know the axis when compiled.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace octacut {

class ChunkPool {
 public:
  // Its items end at its own alignment, so that the slot for the next item
  // tells by itself whether there is one.
  struct alignas(256) Chunk {
    Chunk* next;
    uint32_t size;  // known once no item is added any more
    uint32_t items[61];

    static bool IsEnd(const uint32_t* slot) {
      return (reinterpret_cast<uintptr_t>(slot) & (sizeof(Chunk) - 1)) == 0;
    }
  };
  static_assert(sizeof(Chunk) == 256);

  Chunk* Allocate() {
    if (free_ == nullptr) {
      AddBlock();
    }
    Chunk* chunk = std::exchange(free_, free_->next);
    chunk->next = nullptr;
    return chunk;
  }
  void Free(Chunk* chunk) {
    chunk->next = free_;
    free_ = chunk;
  }
  size_t MemoryBytes() const { return blocks_.size() * kBlock * sizeof(Chunk); }
  // Takes over another pool's chunks, those in use and those that are not.
  void Absorb(ChunkPool& other) {
    std::move(other.blocks_.begin(),
              other.blocks_.end(),
              std::back_inserter(blocks_));
    if (other.free_ != nullptr) {
      Chunk* last = other.free_;
      while (last->next != nullptr) {
        last = last->next;
      }
      last->next = std::exchange(free_, other.free_);
    }
    other = ChunkPool();
  }

 private:
  static constexpr size_t kBlock = 16;
  void AddBlock() {
    blocks_.push_back(std::make_unique_for_overwrite<Chunk[]>(kBlock));
    for (size_t k = 0; k < kBlock; ++k) {
      Free(&blocks_.back()[k]);
    }
  }

  std::vector<std::unique_ptr<Chunk[]>> blocks_;
  Chunk* free_ = nullptr;
};

// A list; first in, first out.
class ChunkList {
 public:
  bool Empty() const { return head_ == nullptr; }

  void Add(uint32_t item, ChunkPool& pool) {
    if (ChunkPool::Chunk::IsEnd(end_)) {
      AddChunk(pool);
    }
    *end_++ = item;
  }

  // Moves all items of a list of the same pool to the end of this one.
  void TakeFrom(ChunkList* other) {
    if (other->Empty()) {
      return;
    }
    CloseTail();
    (tail_ == nullptr ? head_ : tail_->next) = other->head_;
    tail_ = other->tail_;
    end_ = other->end_;
    *other = ChunkList();
  }

  // Takes all items that are in the list now: prefetch(item) some items ahead
  // of body(item). The body may add to this and to other lists.
  template <typename Prefetch, typename Body>
  void Consume(ChunkPool& pool, Prefetch&& prefetch, Body&& body) {
    constexpr uint32_t kAhead = 6;
    CloseTail();
    ChunkPool::Chunk* chunk = head_;
    *this = ChunkList();
    while (chunk != nullptr) {
      const uint32_t size = chunk->size;
      for (uint32_t k = 0; k < size; ++k) {
        if (k + kAhead < size) {
          prefetch(chunk->items[k + kAhead]);
        }
        body(chunk->items[k]);
      }
      pool.Free(std::exchange(chunk, chunk->next));
    }
  }

 private:
  void CloseTail() {
    if (tail_ != nullptr) {
      tail_->size = uint32_t(end_ - tail_->items);
    }
  }
  // Once in 61 times; apart, so that Add is short where it is inlined.
  [[gnu::noinline]] void AddChunk(ChunkPool& pool) {
    CloseTail();
    ChunkPool::Chunk* chunk = pool.Allocate();
    (tail_ == nullptr ? head_ : tail_->next) = chunk;
    tail_ = chunk;
    end_ = chunk->items;
  }

  uint32_t* end_ = nullptr;  // of the tail's items; null is an end as well
  ChunkPool::Chunk* head_ = nullptr;
  ChunkPool::Chunk* tail_ = nullptr;
};

// One list a level and axis.
class BucketQueue {
 public:
  using Lists = std::array<ChunkList, 3>;

  void Add(int32_t level, uint32_t axis, uint32_t item, ChunkPool& pool) {
    if (size_t(level) >= levels_.size()) {
      Grow(level);
    }
    levels_[level][axis].Add(item, pool);
    lowest_ = std::min(lowest_, level);
    highest_ = std::max(highest_, level);
  }
  bool Empty() { return Lowest() > Highest(); }
  // The least and greatest levels that may hold items; of an empty queue
  // Lowest() > Highest().
  int32_t Lowest() {
    while (lowest_ <= highest_ && IsEmpty(levels_[lowest_])) {
      ++lowest_;
    }
    if (lowest_ > highest_) {
      lowest_ = kNoLevel;
      highest_ = -1;
    }
    return lowest_;
  }
  int32_t Highest() const { return highest_; }

  // Moves all items of a queue of the same pool to the ends of the lists.
  void Append(BucketQueue&& other) {
    if (other.levels_.size() > levels_.size()) {
      levels_.resize(other.levels_.size());
    }
    for (int32_t level = other.Lowest(); level <= other.Highest(); ++level) {
      for (size_t axis = 0; axis < 3; ++axis) {
        levels_[level][axis].TakeFrom(&other.levels_[level][axis]);
      }
    }
    lowest_ = std::min(lowest_, other.lowest_);
    highest_ = std::max(highest_, other.highest_);
    other = BucketQueue();
  }

  // Takes all items that are at a level now, prefetch(axis, item) some items
  // ahead of body(axis, item); axis is a std::integral_constant.
  template <typename Prefetch, typename Body>
  void Consume(int32_t level,
               ChunkPool& pool,
               Prefetch&& prefetch,
               Body&& body) {
    if (IsEmpty(levels_[level])) {
      return;
    }
    Lists lists = std::exchange(levels_[level], {});
    const auto consume = [&](auto axis) {
      lists[axis].Consume(
          pool,
          [&](uint32_t item) { prefetch(axis, item); },
          [&](uint32_t item) { body(axis, item); });
    };
    consume(std::integral_constant<int, 0>());
    consume(std::integral_constant<int, 1>());
    consume(std::integral_constant<int, 2>());
  }

 private:
  static constexpr int32_t kNoLevel = 0x7fffffff;
  static bool IsEmpty(const Lists& lists) {
    return lists[0].Empty() && lists[1].Empty() && lists[2].Empty();
  }
  [[gnu::noinline]] void Grow(int32_t level) {
    levels_.resize(size_t(level) + size_t(level) / 2 + 16);
  }

  std::vector<Lists> levels_;
  int32_t lowest_ = kNoLevel;
  int32_t highest_ = -1;
};

}  // namespace octacut
