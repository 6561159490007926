// An array of plain values that grows without a second copy of itself: of
// large arrays the system moves the pages, not the bytes.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace octacut {

template <typename T>
class GrowableArray {
  static_assert(std::is_trivially_copyable_v<T> &&
                std::is_trivially_destructible_v<T>);

 public:
  GrowableArray() = default;
  // What is added has no value yet. Throws std::bad_alloc.
  explicit GrowableArray(size_t size) { Resize(size); }

  void Resize(size_t size) {
    void* moved = std::realloc(data_.get(), (size > 0 ? size : 1) * sizeof(T));
    if (moved == nullptr) {
      throw std::bad_alloc();
    }
    static_cast<void>(data_.release());
    data_.reset(static_cast<T*>(moved));
    size_ = size;
  }
  void Release() {
    data_.reset();
    size_ = 0;
  }

  size_t Size() const { return size_; }
  T& operator[](size_t i) { return data_.get()[i]; }
  const T& operator[](size_t i) const { return data_.get()[i]; }
  const T* Data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(T* data) const { std::free(data); }
  };
  std::unique_ptr<T, Free> data_;
  size_t size_ = 0;
};

}  // namespace octacut
