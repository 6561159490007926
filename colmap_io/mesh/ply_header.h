// The header of a PLY file (Turk 1994): which elements follow, with which
// properties, in which encoding.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "colmap_io/mesh/byte_source.h"

namespace octacut {

enum class PlyEncoding { kAscii, kBinaryLittleEndian, kBinaryBigEndian };

enum class PlyType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kFloat32,
  kFloat64
};

size_t PlyTypeSize(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;  // of the value, or of a list's items
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;  // of a list
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;

  // The fewest bytes that one element can take.
  uint64_t MinBytes(PlyEncoding encoding) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
};

// Throws InputError naming the line.
PlyHeader ReadPlyHeader(ByteSource* source);

}  // namespace octacut
