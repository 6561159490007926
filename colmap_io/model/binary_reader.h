// Little-endian values from a stream whose remaining size is known, so that
// counts can be checked before memory is taken.
// Private to this folder.
#pragma once

#include <bit>
#include <cstdint>
#include <istream>
#include <sstream>
#include <string>
#include <string_view>

namespace octacut {

static_assert(std::endian::native == std::endian::little,
              "binary models are copied as they are: little endian");

class BinaryReader {
 public:
  // A stream that cannot seek is read to its end at once.
  BinaryReader(std::istream& stream, std::string name);
  BinaryReader(const BinaryReader&) = delete;
  BinaryReader& operator=(const BinaryReader&) = delete;

  const std::string& Name() const { return name_; }

  // `field` names the value in the message when the file ends early.
  template <typename T>
  T Read(std::string_view field) {
    T value;
    ReadBytes(&value, sizeof(T), field);
    return value;
  }
  void ReadBytes(void* out, size_t size, std::string_view field);

  // A zero-terminated string.
  std::string ReadString(std::string_view field);

  // A u64 count of items of at least `min_bytes` bytes; refused when the file
  // cannot hold that many.
  uint64_t ReadCount(uint64_t min_bytes, std::string_view field);

  // Refuses bytes after the end of the content.
  void ExpectEnd() const;

  [[noreturn]] void Fail(std::string_view message) const;

 private:
  std::istringstream copy_;  // of a stream that cannot seek
  std::istream* stream_;
  std::string name_;
  uint64_t remaining_ = 0;
};

}  // namespace octacut
