// Collects small pieces before they go to a stream.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>

namespace octacut {

class OutputBuffer {
 public:
  explicit OutputBuffer(std::ostream* stream) : stream_(stream) {
    buffer_.reserve(kBlock + 256);
  }
  ~OutputBuffer() { Flush(); }
  OutputBuffer(const OutputBuffer&) = delete;
  OutputBuffer& operator=(const OutputBuffer&) = delete;

  template <typename... Arguments>
  void Print(fmt::format_string<Arguments...> format,
             Arguments&&... arguments) {
    // format_to would compile all of fmt's formatting once more for every file.
    buffer_ += fmt::format(format, std::forward<Arguments>(arguments)...);
    FlushIfFull();
  }

  void Byte(uint8_t value) {
    buffer_.push_back(static_cast<char>(value));
    FlushIfFull();
  }
  // Little endian.
  void Uint32(uint32_t value) {
    for (int byte = 0; byte < 4; ++byte) {
      buffer_.push_back(static_cast<char>(value >> (8 * byte) & 0xff));
    }
    FlushIfFull();
  }
  void Float(double value) {
    Uint32(std::bit_cast<uint32_t>(static_cast<float>(value)));
  }
  // To be asked before anything else is written to the stream.
  void Flush() {
    stream_->write(buffer_.data(),
                   static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

 private:
  static constexpr size_t kBlock = size_t{1} << 16;

  void FlushIfFull() {
    if (buffer_.size() >= kBlock) {
      Flush();
    }
  }

  std::ostream* stream_;
  std::string buffer_;
};

}  // namespace octacut
