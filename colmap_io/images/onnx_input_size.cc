#include "colmap_io/images/onnx_input_size.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace octacut {
namespace {

using Bytes = std::span<const unsigned char>;

// Field numbers of onnx.proto.
constexpr uint32_t kModelGraph = 7;
constexpr uint32_t kGraphInput = 11;
constexpr uint32_t kValueType = 2;
constexpr uint32_t kTypeTensor = 1;
constexpr uint32_t kTensorShape = 2;
constexpr uint32_t kShapeDimension = 1;
constexpr uint32_t kDimensionValue = 1;

constexpr int64_t kNamed = -1;  // a dimension that is not a number
constexpr int64_t kLargestSide = 1 << 16;

// Protocol buffers: a message is a sequence of fields, each with its number and
// a value that is a number or bytes (a text or another message).
struct Field {
  uint32_t number = 0;
  uint64_t value = 0;
  Bytes bytes;
};

class FieldReader {
 public:
  explicit FieldReader(Bytes bytes) : bytes_(bytes) {}

  // False at the end of the message, and where it is damaged.
  bool Next(Field* field) {
    uint64_t key;
    if (!ReadNumber(&key)) {
      return false;
    }
    *field = {uint32_t(key >> 3), 0, {}};
    switch (key & 7) {
      case 0:
        return ReadNumber(&field->value);
      case 1:
        return Skip(8);
      case 2: {
        uint64_t size;
        if (!ReadNumber(&size) || size > bytes_.size()) {
          return false;
        }
        field->bytes = bytes_.first(size_t(size));
        return Skip(size_t(size));
      }
      case 5:
        return Skip(4);
      default:
        return false;
    }
  }

 private:
  bool Skip(size_t count) {
    if (count > bytes_.size()) {
      return false;
    }
    bytes_ = bytes_.subspan(count);
    return true;
  }

  // Seven bits a byte, the lowest first; the eighth says that another follows.
  bool ReadNumber(uint64_t* value) {
    *value = 0;
    for (int shift = 0; shift < 64 && !bytes_.empty(); shift += 7) {
      const unsigned char byte = bytes_.front();
      bytes_ = bytes_.subspan(1);
      *value |= uint64_t(byte & 0x7f) << shift;
      if ((byte & 0x80) == 0) {
        return true;
      }
    }
    return false;
  }

  Bytes bytes_;
};

// The first message of that number in a message; empty where there is none.
Bytes Inner(Bytes message, uint32_t number) {
  FieldReader reader(message);
  for (Field field; reader.Next(&field);) {
    if (field.number == number) {
      return field.bytes;
    }
  }
  return {};
}

std::vector<int64_t> Dimensions(Bytes value_info) {
  const Bytes shape =
      Inner(Inner(Inner(value_info, kValueType), kTypeTensor), kTensorShape);
  std::vector<int64_t> dimensions;
  FieldReader reader(shape);
  for (Field field; reader.Next(&field);) {
    if (field.number != kShapeDimension) {
      continue;
    }
    int64_t& dimension = dimensions.emplace_back(kNamed);
    FieldReader inner(field.bytes);
    for (Field part; inner.Next(&part);) {
      if (part.number == kDimensionValue && part.bytes.empty()) {
        dimension = int64_t(part.value);
      }
    }
  }
  return dimensions;
}

}  // namespace

std::optional<cv::Size> OnnxInputSize(std::string_view bytes) {
  const Bytes model(reinterpret_cast<const unsigned char*>(bytes.data()),
                    bytes.size());
  FieldReader reader(Inner(model, kModelGraph));
  for (Field field; reader.Next(&field);) {
    if (field.number != kGraphInput) {
      continue;
    }
    const std::vector<int64_t> dimensions = Dimensions(field.bytes);
    if (dimensions.size() == 4 && dimensions[1] == 3) {
      const int64_t height = dimensions[2];
      const int64_t width = dimensions[3];
      if (height > 0 && height <= kLargestSide && width > 0 &&
          width <= kLargestSide) {
        return cv::Size(int(width), int(height));
      }
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace octacut
