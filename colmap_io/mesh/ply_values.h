// The values after a PLY header, one at a time, whatever their encoding.
#pragma once

#include <bit>
#include <cstring>
#include <string_view>

#include "colmap_io/mesh/byte_source.h"
#include "colmap_io/mesh/ply_header.h"

namespace octacut {

class PlyValues {
 public:
  PlyValues(ByteSource* source, PlyEncoding encoding)
      : source_(source), encoding_(encoding) {}

  const ByteSource& Source() const { return *source_; }

  // Names the element that the following values are of, for errors.
  void SetElement(const PlyElement* element, uint64_t index) {
    element_ = element;
    index_ = index;
  }

  // Every type of PLY fits into a double.
  double Read(PlyType type) {
    switch (encoding_) {
      case PlyEncoding::kAscii:
        return ReadText();
      case PlyEncoding::kBinaryLittleEndian:
        return ReadBinary<std::endian::native != std::endian::little>(type);
      case PlyEncoding::kBinaryBigEndian:
        return ReadBinary<std::endian::native != std::endian::big>(type);
    }
    return 0;
  }

  // The number of items of a list, checked against what the file still holds.
  uint64_t ReadCount(const PlyProperty& list);

  void SkipProperty(const PlyProperty& property);

  [[noreturn]] void Fail(std::string_view message) const;

 private:
  template <typename Stored, bool swap>
  double ReadAs() {
    unsigned char bytes[sizeof(Stored)];
    if (!source_->Read(bytes, sizeof(Stored))) {
      FailTruncated();
    }
    if constexpr (swap) {
      for (size_t i = 0; i < sizeof(Stored) / 2; ++i) {
        std::swap(bytes[i], bytes[sizeof(Stored) - 1 - i]);
      }
    }
    Stored value;
    std::memcpy(&value, bytes, sizeof(Stored));
    return static_cast<double>(value);
  }

  template <bool swap>
  double ReadBinary(PlyType type) {
    switch (type) {
      case PlyType::kInt8:
        return ReadAs<int8_t, swap>();
      case PlyType::kUint8:
        return ReadAs<uint8_t, swap>();
      case PlyType::kInt16:
        return ReadAs<int16_t, swap>();
      case PlyType::kUint16:
        return ReadAs<uint16_t, swap>();
      case PlyType::kInt32:
        return ReadAs<int32_t, swap>();
      case PlyType::kUint32:
        return ReadAs<uint32_t, swap>();
      case PlyType::kFloat32:
        return ReadAs<float, swap>();
      case PlyType::kFloat64:
        return ReadAs<double, swap>();
    }
    return 0;
  }

  double ReadText();
  [[noreturn]] void FailTruncated() const;

  ByteSource* source_;
  PlyEncoding encoding_;
  const PlyElement* element_ = nullptr;
  uint64_t index_ = 0;
};

}  // namespace octacut
