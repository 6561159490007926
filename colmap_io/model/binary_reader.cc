#include "colmap_io/model/binary_reader.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "core/base/error.h"

namespace octacut {

BinaryReader::BinaryReader(std::istream& stream, std::string name)
    : stream_(&stream), name_(std::move(name)) {
  const std::istream::pos_type begin = stream.tellg();
  if (begin != std::istream::pos_type(-1)) {
    stream.seekg(0, std::ios::end);
    const std::istream::pos_type end = stream.tellg();
    stream.seekg(begin);
    if (stream.good() && end >= begin) {
      remaining_ = uint64_t(end - begin);
      return;
    }
  }
  stream.clear();
  std::string content((std::istreambuf_iterator<char>(stream)),
                      std::istreambuf_iterator<char>());
  remaining_ = content.size();
  copy_.str(std::move(content));
  stream_ = &copy_;
}

void BinaryReader::ReadBytes(void* out, size_t size, std::string_view field) {
  if (size > remaining_ ||
      !stream_->read(static_cast<char*>(out), std::streamsize(size))) {
    Fail(fmt::format("ends within {}", field));
  }
  remaining_ -= size;
}

std::string BinaryReader::ReadString(std::string_view field) {
  constexpr size_t kMaxLength = 65535;
  std::string text;
  while (const char c = Read<char>(field)) {
    if (text.size() == kMaxLength) {
      Fail(fmt::format("{} is longer than {} bytes", field, kMaxLength));
    }
    text.push_back(c);
  }
  return text;
}

uint64_t BinaryReader::ReadCount(uint64_t min_bytes, std::string_view field) {
  const auto count = Read<uint64_t>(field);
  if (count > remaining_ / min_bytes) {
    Fail(fmt::format("{} = {}: the remaining {} bytes hold at most {}",
                     field,
                     count,
                     remaining_,
                     remaining_ / min_bytes));
  }
  return count;
}

void BinaryReader::ExpectEnd() const {
  if (remaining_ > 0) {
    Fail(fmt::format("{} bytes follow after the end of the content",
                     remaining_));
  }
}

void BinaryReader::Fail(std::string_view message) const {
  throw InputError(fmt::format("{}: {}", name_, message));
}

}  // namespace octacut
