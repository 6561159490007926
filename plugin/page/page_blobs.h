// The binary parts of a page: quantised meshes and photographs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "plugin/page/base64.h"

namespace octacut {

// What the page's JSON refers to by number; `texts` in base64.
class PageBlobs {
 public:
  // Returns the number of the blob.
  size_t Add(std::span<const uint8_t> bytes) {
    texts_.push_back(EncodeBase64(bytes));
    return texts_.size() - 1;
  }
  // Bytes of plain values, little endian.
  template <typename T>
  size_t AddValues(const std::vector<T>& values) {
    return Add({reinterpret_cast<const uint8_t*>(values.data()),
                values.size() * sizeof(T)});
  }
  const std::vector<std::string>& Texts() const { return texts_; }

 private:
  std::vector<std::string> texts_;
};

}  // namespace octacut
