#include "colmap_io/mesh/ply_values.h"

#include <fmt/format.h>

#include <cmath>

#include "colmap_io/mesh/text_numbers.h"

namespace octacut {

double PlyValues::ReadText() {
  const std::string_view word = source_->ReadToken();
  if (word.empty()) {
    FailTruncated();
  }
  double value = 0;
  if (!ParseNumber(word, &value)) {
    Fail(fmt::format("\"{}\" is not a number", word.substr(0, 40)));
  }
  return value;
}

uint64_t PlyValues::ReadCount(const PlyProperty& list) {
  const double count = Read(list.count_type);
  const uint64_t item_bytes =
      encoding_ == PlyEncoding::kAscii ? 2 : PlyTypeSize(list.type);
  if (!(count >= 0) || count != std::floor(count) || count > UINT32_MAX) {
    Fail(fmt::format("list {} has the length {}", list.name, count));
  }
  const uint64_t result = static_cast<uint64_t>(count);
  if (result > 0 && source_->Remaining() < result * item_bytes - 1) {
    Fail(fmt::format("list {} has the length {}, but only {} bytes follow",
                     list.name,
                     result,
                     source_->Remaining()));
  }
  return result;
}

void PlyValues::SkipProperty(const PlyProperty& property) {
  const uint64_t count = property.is_list ? ReadCount(property) : 1;
  if (encoding_ == PlyEncoding::kAscii) {
    // Whatever it is: nobody needs it to be a number.
    for (uint64_t i = 0; i < count; ++i) {
      if (source_->ReadToken().empty()) {
        FailTruncated();
      }
    }
  } else if (!source_->Skip(count * PlyTypeSize(property.type))) {
    FailTruncated();
  }
}

void PlyValues::Fail(std::string_view message) const {
  source_->Fail(
      fmt::format("{} {}: {}",
                  element_ != nullptr ? element_->name : std::string("element"),
                  index_,
                  message));
}

void PlyValues::FailTruncated() const {
  Fail(fmt::format("the file ends here, {} were announced",
                   element_ != nullptr ? element_->count : 0));
}

}  // namespace octacut
